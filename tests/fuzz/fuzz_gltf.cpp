// libFuzzer: any bytes as a .gltf or .glb. Loading must return a scene whose indices all lead somewhere, or
// throw lambent::Error.
#include "scene/gltf_bytes.h"

#include <tbb/global_control.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace {

using namespace lambent;
using namespace lambent::scene;

void require(bool condition)
{
    if (!condition)
        std::abort();
}

template <class Elements>
bool one_each_or_none(const Elements& elements, std::size_t vertices)
{
    return elements.empty() || elements.size() == vertices;
}

void check_mesh(const Mesh& mesh, const Scene& scene)
{
    const std::size_t vertices = mesh.positions.size();
    require(mesh.normals.size() == vertices);
    require(one_each_or_none(mesh.tangents, vertices) && one_each_or_none(mesh.colors, vertices));
    require(one_each_or_none(mesh.texcoords[0], vertices) && one_each_or_none(mesh.texcoords[1], vertices));
    require(static_cast<std::size_t>(mesh.material) < scene.materials.size());
    for (const glm::uvec3 triangle : mesh.triangles)
        require(triangle.x < vertices && triangle.y < vertices && triangle.z < vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
        require(std::isfinite(mesh.positions[i].x + mesh.positions[i].y + mesh.positions[i].z));
        const glm::vec3 n = mesh.normals[i];
        require(std::abs(n.x * n.x + n.y * n.y + n.z * n.z - 1.0f) < 1e-4f);
    }
}

void check_scene(const Scene& scene)
{
    require(!scene.materials.empty());
    for (const Instance& instance : scene.instances)
        require(static_cast<std::size_t>(instance.mesh) < scene.meshes.size() && instance.material == -1);
    for (const Mesh& mesh : scene.meshes)
        check_mesh(mesh, scene);
    for (const Material& material : scene.materials)
        for (const TextureUse* use :
             {&material.base_color_texture, &material.metallic_roughness_texture, &material.normal_texture,
              &material.occlusion_texture, &material.emissive_texture})
            require(use->image >= -1 && use->image < static_cast<int>(scene.images.size()) &&
                    use->texcoord >= 0 && use->texcoord <= 1);
    const Bounds box = bounds(scene);
    require(scene.instances.empty() || std::isfinite(box.high.x - box.low.x));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    // One thread: the same input then always takes the same way.
    static const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    try {
        Warnings warnings;
        check_scene(load_gltf_bytes({"fuzz", {data, size}, std::nullopt}, warnings));
    } catch (const Error&) {
    }
    return 0;
}
