#include "scene/scene.h"

#include "scene/index.h"
#include "scene/transform.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <cmath>

namespace lambent::scene {
namespace {

Bounds merge(const Bounds& a, const Bounds& b)
{
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
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

std::size_t triangle_count(const Scene& scene)
{
    std::size_t count = 0;
    for (const Instance& instance : scene.instances)
        count += scene.meshes[at(instance.mesh)].triangles.size();
    return count;
}

Bounds bounds(const Scene& scene)
{
    Bounds box;
    for (const Instance& instance : scene.instances)
        box = merge(box, instance_bounds(scene.meshes[at(instance.mesh)], instance.transform));
    return box;
}

Bounds framed_bounds(const Scene& scene)
{
    const bool rests = scene.rest_bounds && scene.rest_bounds->low.x <= scene.rest_bounds->high.x;
    return rests ? *scene.rest_bounds : bounds(scene);
}

bool is_invertible(const glm::dmat4& transform)
{
    const glm::dmat3 linear(transform);
    const double determinant = std::abs(glm::determinant(linear));
    const double box = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
    return determinant > 1e-12 * box && determinant > 1e-36 && determinant < 1e36;
}

} // namespace lambent::scene
