#include "scene/gltf/gltf_topology.h"

#include "scene/gltf_document/gltf_model.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace lambent::scene {
namespace {

using CornerList = std::span<const std::uint32_t>;

void add_separate_triangles(CornerList corners, std::vector<glm::uvec3>& triangles)
{
    const std::size_t before = triangles.size(), more = corners.size() / 3;
    triangles.resize(before + more);
    if (more != 0)
        std::memcpy(triangles.data() + before, corners.data(), more * sizeof(glm::uvec3));
}

void add_joined_triangles(CornerList corners, bool strip, std::vector<glm::uvec3>& triangles)
{
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        const glm::uvec3 triangle =
            strip ? glm::uvec3(corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2])
                  : glm::uvec3(corners[i + 1], corners[i + 2], corners[0]);
        if (triangle.x != triangle.y && triangle.y != triangle.z && triangle.z != triangle.x)
            triangles.push_back(triangle);
    }
}

void add_lines(CornerList corners, int mode, std::vector<glm::uvec2>& lines)
{
    const auto add = [&](std::uint32_t from, std::uint32_t to) {
        if (from != to)
            lines.emplace_back(from, to);
    };
    const std::size_t step = mode == gltf::Mode::lines ? 2 : 1;
    for (std::size_t i = 0; i + 1 < corners.size(); i += step)
        add(corners[i], corners[i + 1]);
    // A loop of two vertices is a single line.
    if (mode == gltf::Mode::line_loop && corners.size() > 2)
        add(corners.back(), corners.front());
}

// Returns how many are left over after the last whole triangle or line.
std::size_t connect_run(CornerList corners, int mode, Mesh& mesh)
{
    switch (mode) {
    case gltf::Mode::points:
        mesh.points.insert(mesh.points.end(), corners.begin(), corners.end());
        return 0;
    case gltf::Mode::lines:
        add_lines(corners, mode, mesh.lines);
        return corners.size() % 2;
    case gltf::Mode::line_loop:
    case gltf::Mode::line_strip:
        add_lines(corners, mode, mesh.lines);
        return corners.size() < 2 ? corners.size() : 0;
    case gltf::Mode::triangles:
        add_separate_triangles(corners, mesh.triangles);
        return corners.size() % 3;
    default:
        add_joined_triangles(corners, mode == gltf::Mode::triangle_strip, mesh.triangles);
        return corners.size() < 3 ? corners.size() : 0;
    }
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

std::uint32_t restart_index(int component_type)
{
    if (component_type == gltf::Component::u8)
        return std::numeric_limits<std::uint8_t>::max();
    if (component_type == gltf::Component::u16)
        return std::numeric_limits<std::uint16_t>::max();
    return std::numeric_limits<std::uint32_t>::max();
}

UnusedCorners connect(std::span<const std::uint32_t> corners, std::uint32_t restart, int mode, Mesh& mesh)
{
    UnusedCorners unused;
    std::size_t left_over = 0;
    for (auto begin = corners.begin();; ++begin) {
        const auto end = std::find(begin, corners.end(), restart);
        left_over += connect_run({begin, end}, mode, mesh);
        if (end == corners.end())
            break;
        ++unused.restarts;
        begin = end;
    }
    unused.left_over = unused.restarts == 0 ? left_over : 0;
    return unused;
}

std::vector<std::uint32_t> choose_vertices(Mesh& mesh, std::size_t vertices)
{
    const std::size_t corners = 3 * mesh.triangles.size() + 2 * mesh.lines.size() + mesh.points.size();
    if (corners >= vertices)
        return {};
    std::vector<std::uint32_t> used;
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
