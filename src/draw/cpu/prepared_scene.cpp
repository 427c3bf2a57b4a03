#include "draw/cpu/prepared_scene.h"

#include <glm/matrix.hpp>

namespace lambent::draw {

PreparedScene::PreparedScene(const scene::Scene& scene, TexelTransfer transfer)
    : visibility_(scene), textures_(scene, transfer)
{
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
        context.textures = textures_.of(*context.material);
        surfaces_.push_back(context);
    }
}

} // namespace lambent::draw
