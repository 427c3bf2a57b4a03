#include "draw/textures/scene_textures.h"

#include "draw/textures/mask_coverage.h"

#include <tbb/parallel_for.h>

namespace lambent::draw {
namespace {

// The mean vertex alpha of each mask material, where vertices without colours have 1; 1 for other materials.
std::vector<float> vertex_alphas(const scene::Scene& scene)
{
    std::vector<double> sums(scene.materials.size(), 0.0), counts(scene.materials.size(), 0.0);
    for (const scene::Instance& instance : scene.instances) {
        const scene::Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const std::size_t material = scene::material_of(scene, instance);
        if (scene.materials[material].alpha_mode != scene::AlphaMode::mask)
            continue;
        counts[material] += static_cast<double>(mesh.positions.size());
        for (const glm::vec4& color : mesh.colors)
            sums[material] += static_cast<double>(color.a);
        if (mesh.colors.empty())
            sums[material] += static_cast<double>(mesh.positions.size());
    }
    std::vector<float> means(scene.materials.size(), 1.0f);
    for (std::size_t i = 0; i < means.size(); ++i)
        if (counts[i] > 0.0)
            means[i] = static_cast<float>(sums[i] / counts[i]);
    return means;
}

// `least_alpha` for the base colour texture; unset if the material is no mask or its sampler has no mip maps.
std::optional<float> mask_of(const scene::Material& material, float vertex_alpha)
{
    if (material.alpha_mode != scene::AlphaMode::mask || !material.base_color_texture.sampler.mipmapped)
        return std::nullopt;
    return least_mask_alpha(material, vertex_alpha);
}

} // namespace

SceneTextures::SceneTextures(const scene::Scene& scene, TexelTransfer color)
{
    list_textures(scene, color);
    tbb::parallel_for(std::size_t{0}, textures_.size(), [&](std::size_t i) {
        Packed& packed = textures_[i];
        packed.texture = pack_texture(scene.images[static_cast<std::size_t>(packed.image)], packed.sampler,
                                      packed.transfer, packed.least_alpha);
    });
}

void SceneTextures::list_textures(const scene::Scene& scene, TexelTransfer color)
{
    const std::vector<float> alphas = vertex_alphas(scene);
    const auto for_each_use = [&](std::size_t material, const auto& visit) {
        const scene::Material& m = scene.materials[material];
        for_each_texture(m, [&](int number, const scene::TextureUse& use, scene::TextureCodes codes) {
            const bool is_mask = number == scene::texture_base_color;
            visit(static_cast<std::size_t>(number), use,
                  codes == scene::TextureCodes::color ? color : TexelTransfer::none,
                  is_mask ? mask_of(m, alphas[material]) : std::nullopt);
        });
    };
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        for_each_use(i, [&](std::size_t, const scene::TextureUse& use, TexelTransfer transfer,
                            std::optional<float> least_alpha) { add(use, transfer, least_alpha); });
    materials_.resize(scene.materials.size());
    for (std::size_t i = 0; i < scene.materials.size(); ++i) // textures_ no longer grows: pointers stay valid
        for_each_use(i, [&](std::size_t number, const scene::TextureUse& use, TexelTransfer transfer,
                            std::optional<float> least_alpha) {
            materials_[i][number] = find(use, transfer, least_alpha);
        });
}

void SceneTextures::add(const scene::TextureUse& use, TexelTransfer transfer,
                        std::optional<float> least_alpha)
{
    if (use.image >= 0 && !find(use, transfer, least_alpha))
        textures_.push_back({use.image, use.sampler, transfer, least_alpha, {}});
}

const PackedTexture* SceneTextures::find(const scene::TextureUse& use, TexelTransfer transfer,
                                         std::optional<float> least_alpha) const
{
    for (const Packed& packed : textures_)
        if (packed.image == use.image && packed.transfer == transfer && packed.least_alpha == least_alpha &&
            packed.sampler == use.sampler)
            return &packed.texture;
    return nullptr;
}

int SceneTextures::index(const PackedTexture* texture) const
{
    for (std::size_t i = 0; i < textures_.size(); ++i)
        if (&textures_[i].texture == texture)
            return static_cast<int>(i);
    return -1;
}

} // namespace lambent::draw
