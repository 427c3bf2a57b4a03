#include "scene/gltf_mend.h"

#include "scene/tinygltf_header.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambent::scene {
namespace {

bool is_finite(const glm::vec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace

std::uint32_t restart_index(int component_type)
{
    if (component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE)
        return std::numeric_limits<std::uint8_t>::max();
    if (component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT)
        return std::numeric_limits<std::uint16_t>::max();
    return std::numeric_limits<std::uint32_t>::max();
}

std::vector<std::span<const std::uint32_t>> runs_between(std::span<const std::uint32_t> corners,
                                                         std::uint32_t restart)
{
    std::vector<std::span<const std::uint32_t>> runs;
    for (auto begin = corners.begin(); begin != corners.end();) {
        const auto end = std::find(begin, corners.end(), restart);
        if (begin != end)
            runs.emplace_back(begin, end);
        begin = end == corners.end() ? end : end + 1;
    }
    return runs;
}

std::size_t clamp_colors(std::vector<glm::vec4>& colors)
{
    constexpr float slack = 1e-4f; // what exporters' own arithmetic leaves
    std::size_t count = 0;
    for (glm::vec4& color : colors) {
        const glm::vec4 kept = glm::clamp(color, 0.0f, 1.0f);
        const glm::vec4 over = glm::abs(color - kept);
        count += std::max({over.r, over.g, over.b, over.a}) > slack ? 1 : 0;
        color = kept;
    }
    return count;
}

std::size_t remove_broken_triangles(Mesh& mesh)
{
    std::vector<bool> broken(mesh.positions.size());
    for (std::size_t vertex = 0; vertex < broken.size(); ++vertex)
        broken[vertex] = !is_finite(mesh.positions[vertex]);
    const std::size_t removed = std::erase_if(mesh.triangles, [&](const glm::uvec3& triangle) {
        return broken[triangle.x] || broken[triangle.y] || broken[triangle.z];
    });
    const glm::vec3 elsewhere =
        mesh.triangles.empty() ? glm::vec3(0.0f) : mesh.positions[mesh.triangles.front().x];
    for (std::size_t vertex = 0; vertex < broken.size(); ++vertex)
        if (broken[vertex])
            mesh.positions[vertex] = elsewhere;
    return removed;
}

} // namespace lambent::scene
