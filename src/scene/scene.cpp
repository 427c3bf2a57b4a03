#include "scene/scene.h"

#include "scene/index.h"
#include "scene/transform.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

namespace lambent::scene {
namespace {

Bounds merge(const Bounds& a, const Bounds& b)
{
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

// If all instances together have more vertices than this, meshes of more than `few_uses` instances are visited only
// once.
constexpr std::size_t most_vertices_looked_at = 200'000'000, few_uses = 64;

std::vector<glm::vec3> corners_of(const Bounds& box)
{
    std::vector<glm::vec3> corners;
    if (box.low.x <= box.high.x)
        for (int corner = 0; corner < 8; ++corner)
            corners.emplace_back(corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                                 corner & 4 ? box.high.z : box.low.z);
    return corners;
}

Bounds instance_bounds(const Mesh& mesh, const glm::mat4& transform)
{
    constexpr std::size_t grain = 4096;
    const auto extend = [&](const tbb::blocked_range<std::size_t>& range, Bounds box) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const glm::vec3 point(transform * glm::vec4(mesh.positions[i], 1.0f));
            box.low = glm::min(box.low, point);
            box.high = glm::max(box.high, point);
        }
        return box;
    };
    return tbb::parallel_reduce(tbb::blocked_range<std::size_t>(0, mesh.positions.size(), grain), Bounds{},
                                extend, merge);
}

} // namespace

std::size_t material_of(const Scene& scene, const Instance& instance)
{
    const int own = scene.meshes[static_cast<std::size_t>(instance.mesh)].material;
    return static_cast<std::size_t>(instance.material >= 0 ? instance.material : own);
}

bool has_lines(const Mesh& mesh)
{
    return !mesh.points.empty() || !mesh.lines.empty();
}

bool has_lines(const Scene& scene)
{
    return std::any_of(scene.meshes.begin(), scene.meshes.end(),
                       [](const Mesh& mesh) { return has_lines(mesh); });
}

bool is_empty(const Mesh& mesh)
{
    return mesh.triangles.empty() && !has_lines(mesh);
}

std::size_t triangle_count(const Scene& scene)
{
    std::size_t count = 0;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[at(instance.mesh)];
        count += mesh.triangles.size() + 2 * (mesh.points.size() + mesh.lines.size());
    }
    return count;
}

LineCount line_count(const Scene& scene)
{
    LineCount count;
    for (const Instance& instance : scene.instances) {
        count.points += scene.meshes[at(instance.mesh)].points.size();
        count.lines += scene.meshes[at(instance.mesh)].lines.size();
    }
    return count;
}

Bounds bounds(const Scene& scene)
{
    std::vector<std::size_t> uses(scene.meshes.size(), 0);
    std::size_t vertices = 0;
    for (const Instance& instance : scene.instances) {
        ++uses[at(instance.mesh)];
        vertices += scene.meshes[at(instance.mesh)].positions.size();
    }
    std::vector<Mesh> boxes(scene.meshes.size());
    Bounds box;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[at(instance.mesh)];
        Mesh& around = boxes[at(instance.mesh)];
        const bool rough = vertices > most_vertices_looked_at && uses[at(instance.mesh)] > few_uses;
        if (rough && around.positions.empty())
            around.positions = corners_of(instance_bounds(mesh, glm::mat4(1.0f)));
        box = merge(box, instance_bounds(rough ? around : mesh, instance.transform));
    }
    return box;
}

glm::dvec3 better_origin(const Bounds& bounds)
{
    constexpr double far_away = 64.0;
    if (!(bounds.low.x <= bounds.high.x))
        return glm::dvec3(0.0);
    const glm::dvec3 low(bounds.low), high(bounds.high), middle = 0.5 * (low + high);
    const double radius = 0.5 * glm::length(high - low);
    if (!(glm::length(middle) > far_away * radius))
        return glm::dvec3(0.0);
    // A multiple of a power of two near the scene's size, so that round coordinates stay round numbers.
    const double step = radius > 0.0 ? std::exp2(std::ceil(std::log2(radius))) : 0.0;
    return step > 0.0 ? step * glm::round(middle / step) : middle;
}

Bounds framed_bounds(const Scene& scene)
{
    const bool rests = scene.rest_bounds && scene.rest_bounds->low.x <= scene.rest_bounds->high.x;
    return rests ? *scene.rest_bounds : bounds(scene);
}

} // namespace lambent::scene
