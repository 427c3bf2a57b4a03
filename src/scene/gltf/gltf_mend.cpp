#include "scene/gltf/gltf_mend.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lambent::scene {
namespace {

bool is_finite(const glm::vec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Some vertex of a mesh that is not empty.
std::uint32_t some_corner(const Mesh& mesh)
{
    if (!mesh.triangles.empty())
        return mesh.triangles.front().x;
    return mesh.lines.empty() ? mesh.points.front() : mesh.lines.front().x;
}

} // namespace

std::size_t clamp_colors(std::vector<glm::vec4>& colors)
{
    constexpr float slack = 1e-4f; // rounding errors of exporters
    std::size_t count = 0;
    for (glm::vec4& color : colors) {
        const glm::vec4 kept = glm::clamp(color, 0.0f, 1.0f);
        const glm::vec4 over = glm::abs(color - kept);
        count += std::max({over.r, over.g, over.b, over.a}) > slack ? 1 : 0;
        color = kept;
    }
    return count;
}

std::size_t remove_broken_elements(Mesh& mesh)
{
    std::vector<bool> broken(mesh.positions.size());
    for (std::size_t vertex = 0; vertex < broken.size(); ++vertex)
        broken[vertex] = !is_finite(mesh.positions[vertex]);
    std::size_t removed = std::erase_if(mesh.triangles, [&](const glm::uvec3& triangle) {
        return broken[triangle.x] || broken[triangle.y] || broken[triangle.z];
    });
    removed +=
        std::erase_if(mesh.lines, [&](const glm::uvec2& line) { return broken[line.x] || broken[line.y]; });
    removed += std::erase_if(mesh.points, [&](std::uint32_t point) { return broken[point]; });
    const glm::vec3 elsewhere = is_empty(mesh) ? glm::vec3(0.0f) : mesh.positions[some_corner(mesh)];
    for (std::size_t vertex = 0; vertex < broken.size(); ++vertex)
        if (broken[vertex])
            mesh.positions[vertex] = elsewhere;
    return removed;
}

} // namespace lambent::scene
