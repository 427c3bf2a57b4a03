#include "draw/cpu/prepared_scene.h"

#include <glm/matrix.hpp>
#include <tbb/parallel_for.h>

#include <cmath>

namespace lambent::draw {
namespace {

bool same(const scene::Sampler& a, const scene::Sampler& b)
{
    return a.wrap_u == b.wrap_u && a.wrap_v == b.wrap_v && a.magnify_nearest == b.magnify_nearest &&
           a.mipmapped == b.mipmapped;
}

LightSource light_source(const scene::Light& light)
{
    LightSource source;
    source.local = light.kind != scene::LightKind::directional;
    source.position = light.position;
    source.intensity = light.intensity;
    source.axis = light.direction;
    source.range = light.range;
    if (light.kind == scene::LightKind::spot) {
        source.cos_inner = std::cos(light.inner_cone);
        source.cos_outer = std::cos(light.outer_cone);
    }
    return source;
}

} // namespace

PreparedScene::PreparedScene(const scene::Scene& scene, TexelTransfer transfer)
    : scene_(scene), visibility_(scene)
{
    pack_textures(transfer);
    for (const scene::Instance& instance : scene.instances) {
        const scene::Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const int material = instance.material >= 0 ? instance.material : mesh.material;
        SurfaceContext context;
        context.mesh = &mesh;
        context.material = &scene.materials[static_cast<std::size_t>(material)];
        context.transform = instance.transform;
        const glm::mat3 linear(instance.transform);
        context.normals = glm::transpose(glm::inverse(linear));
        context.handedness = glm::determinant(linear) < 0.0f ? -1.0f : 1.0f;
        const scene::Material& m = *context.material;
        context.textures = {texture(m.base_color_texture, transfer),
                            texture(m.metallic_roughness_texture, TexelTransfer::none),
                            texture(m.normal_texture, TexelTransfer::none),
                            texture(m.occlusion_texture, TexelTransfer::none),
                            texture(m.emissive_texture, transfer)};
        surfaces_.push_back(context);
    }
}

void PreparedScene::pack_textures(TexelTransfer color)
{
    const auto add = [&](const scene::TextureUse& use, TexelTransfer transfer) {
        if (use.image >= 0 && !texture(use, transfer))
            textures_.push_back({use.image, use.sampler, transfer, {}});
    };
    for (const scene::Material& m : scene_.materials) {
        add(m.base_color_texture, color);
        add(m.metallic_roughness_texture, TexelTransfer::none);
        add(m.normal_texture, TexelTransfer::none);
        add(m.occlusion_texture, TexelTransfer::none);
        add(m.emissive_texture, color);
    }
    tbb::parallel_for(std::size_t{0}, textures_.size(), [&](std::size_t i) {
        Packed& packed = textures_[i];
        packed.texture = pack_texture(scene_.images[static_cast<std::size_t>(packed.image)], packed.sampler,
                                      packed.transfer);
    });
}

const PackedTexture* PreparedScene::texture(const scene::TextureUse& use, TexelTransfer transfer) const
{
    for (const Packed& packed : textures_)
        if (packed.image == use.image && packed.transfer == transfer && same(packed.sampler, use.sampler))
            return &packed.texture;
    return nullptr;
}

std::vector<LightSource> light_sources(std::span<const scene::Light> lights,
                                       std::span<const scene::Light> more)
{
    std::vector<LightSource> sources;
    for (const scene::Light& light : lights)
        sources.push_back(light_source(light));
    for (const scene::Light& light : more)
        sources.push_back(light_source(light));
    return sources;
}

} // namespace lambent::draw
