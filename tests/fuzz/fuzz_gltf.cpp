// libFuzzer: any bytes as a .gltf or .glb. Loading must return a scene whose indices all lead somewhere, or
// throw lambent::Error; so must each moment, with as many instances.
#include "scene/gltf/gltf.h"

#include <tbb/global_control.h>

#include <algorithm>
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
    require(mesh.normals.size() == vertices || (has_lines(mesh) && mesh.normals.empty()));
    require(!has_lines(mesh) || mesh.triangles.empty());
    require(one_each_or_none(mesh.tangents, vertices) && one_each_or_none(mesh.colors, vertices));
    for (const auto& [number, set] : mesh.texcoords)
        require(number >= 0 && one_each_or_none(set, vertices));
    require(static_cast<std::size_t>(mesh.material) < scene.materials.size());
    for (const glm::uvec3 triangle : mesh.triangles)
        require(triangle.x < vertices && triangle.y < vertices && triangle.z < vertices);
    for (const glm::uvec2 line : mesh.lines)
        require(line.x < vertices && line.y < vertices);
    for (const std::uint32_t point : mesh.points)
        require(point < vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
        // Each by itself: of what is too far away to be drawn, and is kept out of sight, the sum may overflow.
        const glm::vec3 p = mesh.positions[i];
        require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
        if (mesh.normals.empty())
            continue;
        const glm::vec3 n = mesh.normals[i];
        require(std::abs(n.x * n.x + n.y * n.y + n.z * n.z - 1.0f) < 1e-4f);
    }
}

// Of a pose, whose images stay with the renderer, `images` are those of the scene.
void check_scene(const Scene& scene, std::size_t images)
{
    require(!scene.materials.empty());
    for (const Instance& instance : scene.instances)
        require(static_cast<std::size_t>(instance.mesh) < scene.meshes.size() &&
                instance.material < static_cast<int>(scene.materials.size()) &&
                (instance.material == -1 || !scene.animations.empty()));
    for (const Mesh& mesh : scene.meshes)
        check_mesh(mesh, scene);
    for (const Material& material : scene.materials)
        for (const TextureUse* use :
             {&material.base_color_texture, &material.metallic_roughness_texture, &material.normal_texture,
              &material.occlusion_texture, &material.emissive_texture})
            require(use->image >= -1 && use->image < static_cast<int>(images) && use->texcoord >= 0);
    const Bounds box = bounds(scene);
    require(triangle_count(scene) == 0 || std::isfinite(box.high.x - box.low.x));
}

void check_poses(const GltfFile& file, const Scene& scene)
{
    for (std::size_t i = 0; i < std::min<std::size_t>(file.animations().size(), 4); ++i)
        for (const double part : {0.0, 0.37, 1.0}) {
            const Scene posed = file.pose({static_cast<int>(i), part * file.animations()[i].seconds});
            require(posed.instances.size() == scene.instances.size());
            require(posed.meshes.size() == scene.meshes.size());
            require(posed.materials.size() == scene.materials.size());
            check_scene(posed, scene.images.size());
        }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    // One thread: the same input then always takes the same way.
    static const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    try {
        Warnings warnings;
        const GltfFile file({"fuzz", {data, size}, std::nullopt}, warnings);
        const Scene scene = file.scene(std::nullopt, warnings);
        check_scene(scene, scene.images.size());
        check_poses(file, scene);
    } catch (const Error&) {
    }
    return 0;
}
