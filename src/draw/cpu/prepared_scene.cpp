#include "draw/cpu/prepared_scene.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cstddef>

namespace lambent::draw {

TexcoordChoice::TexcoordChoice(const scene::Mesh& mesh, const scene::Material& material)
{
    for_each_texture(material, [&](int number, const scene::TextureUse& use, scene::TextureCodes) {
        of[static_cast<std::size_t>(number)] = add(mesh, use);
    });
}

int TexcoordChoice::add(const scene::Mesh& mesh, const scene::TextureUse& use)
{
    if (use.image < 0)
        return 0;
    const std::vector<glm::vec2>* const set = &mesh.texcoords[use.texcoord];
    const auto end = sets.begin() + count;
    const auto found = std::find(sets.begin(), end, set);
    if (found == end)
        sets[static_cast<std::size_t>(count++)] = set;
    return static_cast<int>(found - sets.begin());
}

PreparedScene::PreparedScene(const scene::Scene& scene, const scene::Scene& posed, TexelTransfer transfer)
    : textures_(scene, transfer)
{
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        alphas_.emplace_back(scene.materials[i], textures_.of(i));
    pose(posed);
}

void PreparedScene::pose(const scene::Scene& posed)
{
    visibility_.reset(); // frees its memory before the next is made
    visibility_.emplace(posed);
    surfaces_.clear();
    material_of_.clear();
    for (const scene::Instance& instance : posed.instances) {
        const scene::Mesh& mesh = posed.meshes[static_cast<std::size_t>(instance.mesh)];
        const std::size_t material = scene::material_of(posed, instance);
        SurfaceContext context;
        context.mesh = &mesh;
        context.material = &posed.materials[material];
        context.transform = instance.transform;
        const glm::mat3 linear(instance.transform);
        context.normals = glm::transpose(glm::inverse(linear));
        context.handedness = glm::determinant(linear) < 0.0f ? -1.0f : 1.0f;
        context.textures = textures_.of(material);
        context.texcoords = TexcoordChoice(mesh, *context.material);
        for_each_texture(*context.material,
                         [&](int number, const scene::TextureUse& use, scene::TextureCodes) {
                             context.uses[static_cast<std::size_t>(number)] = &use;
                         });
        context.normal_scales = normal_scales_of(*context.material);
        surfaces_.push_back(context);
        material_of_.push_back(material);
    }
}

} // namespace lambent::draw
