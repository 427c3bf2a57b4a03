#include "draw/cpu/prepared_scene.h"

#include <glm/matrix.hpp>

namespace lambent::draw {

PreparedScene::PreparedScene(const scene::Scene& scene, const scene::Scene& posed, TexelTransfer transfer)
    : textures_(scene, transfer)
{
    pose(posed);
}

void PreparedScene::pose(const scene::Scene& posed)
{
    visibility_.reset(); // before the next takes memory
    visibility_.emplace(posed);
    surfaces_.clear();
    for (const scene::Instance& instance : posed.instances) {
        const scene::Mesh& mesh = posed.meshes[static_cast<std::size_t>(instance.mesh)];
        const int material = instance.material >= 0 ? instance.material : mesh.material;
        SurfaceContext context;
        context.mesh = &mesh;
        context.material = &posed.materials[static_cast<std::size_t>(material)];
        context.transform = instance.transform;
        const glm::mat3 linear(instance.transform);
        context.normals = glm::transpose(glm::inverse(linear));
        context.handedness = glm::determinant(linear) < 0.0f ? -1.0f : 1.0f;
        context.textures = textures_.of(static_cast<std::size_t>(material));
        surfaces_.push_back(context);
    }
}

} // namespace lambent::draw
