#include "scene/gltf_topology.h"

#include "scene/tinygltf_header.h"

#include <algorithm>
#include <cstring>

namespace lambent::scene {
namespace {

using Corners = std::vector<std::uint32_t>;

std::vector<glm::uvec3> separate_triangles(const Corners& corners)
{
    std::vector<glm::uvec3> triangles(corners.size() / 3);
    if (!triangles.empty())
        std::memcpy(triangles.data(), corners.data(), triangles.size() * sizeof(glm::uvec3));
    return triangles;
}

std::vector<glm::uvec3> joined_triangles(const Corners& corners, bool strip)
{
    std::vector<glm::uvec3> triangles;
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        const glm::uvec3 triangle =
            strip ? glm::uvec3(corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2])
                  : glm::uvec3(corners[i + 1], corners[i + 2], corners[0]);
        if (triangle.x != triangle.y && triangle.y != triangle.z && triangle.z != triangle.x)
            triangles.push_back(triangle);
    }
    return triangles;
}

std::vector<glm::uvec2> lines_of(const Corners& corners, int mode)
{
    std::vector<glm::uvec2> lines;
    const auto add = [&](std::uint32_t from, std::uint32_t to) {
        if (from != to)
            lines.emplace_back(from, to);
    };
    const std::size_t step = mode == TINYGLTF_MODE_LINE ? 2 : 1;
    for (std::size_t i = 0; i + 1 < corners.size(); i += step)
        add(corners[i], corners[i + 1]);
    // Of two corners the way back is the way there.
    if (mode == TINYGLTF_MODE_LINE_LOOP && corners.size() > 2)
        add(corners.back(), corners.front());
    return lines;
}

template <class Action>
void for_each_corner(Mesh& mesh, Action action)
{
    for (glm::uvec3& triangle : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner)
            action(triangle[corner]);
    for (glm::uvec2& line : mesh.lines)
        for (int corner = 0; corner < 2; ++corner)
            action(line[corner]);
    for (std::uint32_t& point : mesh.points)
        action(point);
}

} // namespace

std::size_t connect(const Corners& corners, int mode, Mesh& mesh)
{
    switch (mode) {
    case TINYGLTF_MODE_POINTS:
        mesh.points = corners;
        return 0;
    case TINYGLTF_MODE_LINE:
        mesh.lines = lines_of(corners, mode);
        return corners.size() % 2;
    case TINYGLTF_MODE_LINE_LOOP:
    case TINYGLTF_MODE_LINE_STRIP:
        mesh.lines = lines_of(corners, mode);
        return corners.size() < 2 ? corners.size() : 0;
    case TINYGLTF_MODE_TRIANGLES:
        mesh.triangles = separate_triangles(corners);
        return corners.size() % 3;
    default:
        mesh.triangles = joined_triangles(corners, mode == TINYGLTF_MODE_TRIANGLE_STRIP);
        return corners.size() < 3 ? corners.size() : 0;
    }
}

std::vector<std::uint32_t> choose_vertices(Mesh& mesh, std::size_t vertices)
{
    const std::size_t corners = 3 * mesh.triangles.size() + 2 * mesh.lines.size() + mesh.points.size();
    if (corners >= vertices)
        return {};
    Corners used;
    used.reserve(corners);
    for_each_corner(mesh, [&](std::uint32_t corner) { used.push_back(corner); });
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for_each_corner(mesh, [&](std::uint32_t& corner) {
        corner =
            static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), corner) - used.begin());
    });
    return used;
}

} // namespace lambent::scene
