#include "kitchen/model/solids.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace lambent::kitchen {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

std::uint32_t count_of(const scene::Mesh& mesh)
{
    return static_cast<std::uint32_t>(mesh.positions.size());
}

void add_vertex(scene::Mesh& mesh, const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv)
{
    mesh.positions.push_back(position);
    mesh.normals.push_back(normal);
    mesh.texcoords[0].push_back(uv);
}

// Quads between rows of vertices: rows upwards, columns counter-clockwise.
void join_grid(scene::Mesh& mesh, std::uint32_t first, std::uint32_t columns, std::uint32_t rows)
{
    for (std::uint32_t row = 0; row + 1 < rows; ++row)
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::uint32_t a = first + row * columns + column, b = a + columns;
            mesh.triangles.push_back({a, a + 1, b + 1});
            mesh.triangles.push_back({a, b + 1, b});
        }
}

// The positions of the grid lines on a box's face: `steps` for each half of an edge's arc.
struct BoxLine {
    float side;  ///< -1 or 1
    float slope; ///< of the normal, towards the side
};

std::vector<BoxLine> box_lines(const BoxShape& shape)
{
    if (!(shape.bevel > 0.0f))
        return {{-1.0f, 0.0f}, {1.0f, 0.0f}};
    std::vector<BoxLine> lines;
    for (int i = shape.steps; i >= 0; --i)
        lines.push_back(
            {-1.0f, -std::tan(0.25f * pi * static_cast<float>(i) / static_cast<float>(shape.steps))});
    for (int i = 0; i <= shape.steps; ++i)
        lines.push_back(
            {1.0f, std::tan(0.25f * pi * static_cast<float>(i) / static_cast<float>(shape.steps))});
    return lines;
}

// Texture coordinates of a point of the face with normal `axis`, in metres; v along the grain if the face contains it.
glm::vec2 box_uv(const BoxShape& shape, const glm::vec3& position, int axis)
{
    const int v = shape.grain == axis ? (axis + 2) % 3 : shape.grain;
    const int u = 3 - axis - v;
    return glm::vec2(position[u], position[v]) + shape.uv_offset;
}

void add_box_face(scene::Mesh& mesh, const BoxShape& shape, int axis, float sign)
{
    const std::vector<BoxLine> lines = box_lines(shape);
    const glm::vec3 middle = 0.5f * (shape.low + shape.high);
    const glm::vec3 inner = 0.5f * (shape.high - shape.low) - shape.bevel;
    const int across = (axis + 1) % 3, up = (axis + 2) % 3;
    const std::uint32_t first = count_of(mesh);
    for (const BoxLine& v : lines)
        for (const BoxLine& u : lines) {
            glm::vec3 corner(0.0f), normal(0.0f);
            corner[axis] = sign;
            corner[across] = u.side * sign; // mirrored with the face
            corner[up] = v.side;
            normal[axis] = sign;
            normal[across] = u.slope * sign;
            normal[up] = v.slope;
            normal = glm::normalize(normal);
            const glm::vec3 position = middle + inner * corner + shape.bevel * normal;
            add_vertex(mesh, position, normal, box_uv(shape, position, axis));
        }
    const auto n = static_cast<std::uint32_t>(lines.size());
    join_grid(mesh, first, n, n);
}

// A vertex of a lathe's profile with the normal of one side: corners have two.
struct ProfilePoint {
    glm::vec2 place, normal;
    float length; ///< metres along the profile
};

glm::vec2 right_of(const glm::vec2& direction)
{
    return {direction.y, -direction.x};
}

// The segments of the profile, each with its two end points and their normals.
std::vector<ProfilePoint> profile_pieces(const LatheShape& shape)
{
    const std::vector<glm::vec2>& p = shape.profile;
    std::vector<glm::vec2> normals;
    for (std::size_t i = 0; i + 1 < p.size(); ++i)
        normals.push_back(right_of(glm::normalize(p[i + 1] - p[i])));
    const float least = std::cos(shape.crease);
    const auto joined = [&](std::size_t piece, std::size_t neighbour) {
        const bool smooth_here = glm::dot(normals[piece], normals[neighbour]) > least;
        return smooth_here ? glm::normalize(normals[piece] + normals[neighbour]) : normals[piece];
    };
    std::vector<ProfilePoint> points;
    float length = 0.0f;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        points.push_back({p[i], i > 0 ? joined(i, i - 1) : normals[i], length});
        length += glm::length(p[i + 1] - p[i]);
        points.push_back({p[i + 1], i + 1 < normals.size() ? joined(i, i + 1) : normals[i], length});
    }
    // Where a smooth profile meets the axis, its normal is along the axis.
    for (ProfilePoint* end : {&points.front(), &points.back()})
        if (end->place.x == 0.0f && std::fabs(end->normal.y) > least)
            end->normal = {0.0f, std::copysign(1.0f, end->normal.y)};
    return points;
}

glm::vec3 turned(const glm::vec2& radius_height, int segment, int segments)
{
    const float angle = 2.0f * pi * static_cast<float>(segment % segments) / static_cast<float>(segments);
    return {radius_height.x * std::cos(angle), radius_height.y, -radius_height.x * std::sin(angle)};
}

template <class Vector>
std::vector<Vector> catmull_rom(std::span<const Vector> p, int steps)
{
    std::vector<Vector> curve;
    for (std::size_t i = 0; i + 1 < p.size(); ++i) {
        const Vector before = i > 0 ? p[i - 1] : 2.0f * p[0] - p[1];
        const Vector after = i + 2 < p.size() ? p[i + 2] : 2.0f * p[i + 1] - p[i];
        for (int step = 0; step < steps; ++step) {
            const float t = static_cast<float>(step) / static_cast<float>(steps);
            curve.push_back(0.5f * (2.0f * p[i] + t * (p[i + 1] - before) +
                                    t * t * (2.0f * before - 5.0f * p[i] + 4.0f * p[i + 1] - after) +
                                    t * t * t * (3.0f * p[i] - before - 3.0f * p[i + 1] + after)));
        }
    }
    curve.push_back(p.back());
    return curve;
}

// A direction perpendicular to the first segment of a path.
glm::vec3 any_across(const glm::vec3& tangent)
{
    const glm::vec3 other = std::fabs(tangent.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    return glm::normalize(glm::cross(other, tangent));
}

void add_tube_end(scene::Mesh& mesh, std::uint32_t ring, int segments, const glm::vec3& normal, bool last)
{
    const std::uint32_t first = count_of(mesh);
    for (int i = 0; i < segments; ++i)
        add_vertex(mesh, mesh.positions[ring + static_cast<std::uint32_t>(i)], normal, glm::vec2(0.0f));
    for (std::uint32_t i = 1; i + 1 < static_cast<std::uint32_t>(segments); ++i)
        mesh.triangles.push_back(last ? glm::uvec3(first, first + i, first + i + 1)
                                      : glm::uvec3(first, first + i + 1, first + i));
}

} // namespace

scene::Mesh make_box(const BoxShape& shape)
{
    scene::Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {-1.0f, 1.0f})
            add_box_face(mesh, shape, axis, sign);
    return mesh;
}

scene::Mesh make_lathe(const LatheShape& shape)
{
    scene::Mesh mesh;
    const std::vector<ProfilePoint> points = profile_pieces(shape);
    for (std::size_t piece = 0; piece + 1 < points.size(); piece += 2) {
        const ProfilePoint ends[2] = {points[piece], points[piece + 1]};
        const std::uint32_t first = count_of(mesh);
        const auto row = static_cast<std::uint32_t>(shape.segments) + 1;
        for (const ProfilePoint& end : ends)
            for (int i = 0; i <= shape.segments; ++i)
                add_vertex(mesh, turned(end.place, i, shape.segments), turned(end.normal, i, shape.segments),
                           {static_cast<float>(i) / static_cast<float>(shape.segments), end.length});
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = first + i, b = a + row;
            if (ends[0].place.x > 0.0f)
                mesh.triangles.push_back({a, a + 1, ends[1].place.x > 0.0f ? b + 1 : b});
            if (ends[1].place.x > 0.0f)
                mesh.triangles.push_back({a, b + 1, b});
        }
    }
    return mesh;
}

std::vector<glm::vec2> smooth(std::span<const glm::vec2> points, int steps)
{
    return catmull_rom(points, steps);
}

std::vector<glm::vec3> smooth(std::span<const glm::vec3> points, int steps)
{
    return catmull_rom(points, steps);
}

std::vector<glm::vec3> rounded_path(std::span<const glm::vec3> points, float radius, int steps)
{
    std::vector<glm::vec3> path{points.front()};
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const glm::vec3 begin = points[i] + radius * glm::normalize(points[i - 1] - points[i]);
        const glm::vec3 end = points[i] + radius * glm::normalize(points[i + 1] - points[i]);
        // A quadratic Bezier curve looks like an arc.
        for (int step = 0; step <= steps; ++step) {
            const float t = static_cast<float>(step) / static_cast<float>(steps);
            path.push_back(glm::mix(glm::mix(begin, points[i], t), glm::mix(points[i], end, t), t));
        }
    }
    path.push_back(points.back());
    return path;
}

scene::Mesh make_tube(const TubeShape& shape)
{
    scene::Mesh mesh;
    const std::vector<glm::vec3>& p = shape.path;
    const auto tangent = [&](std::size_t i) {
        return glm::normalize(p[std::min(i + 1, p.size() - 1)] - p[i > 0 ? i - 1 : 0]);
    };
    glm::vec3 across = any_across(tangent(0));
    float length = 0.0f;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const glm::vec3 along = tangent(i);
        across = glm::normalize(across - glm::dot(across, along) * along); // transported without twist
        const glm::vec3 up = glm::cross(along, across);
        length += i > 0 ? glm::length(p[i] - p[i - 1]) : 0.0f;
        for (int segment = 0; segment <= shape.segments; ++segment) {
            const float turns =
                static_cast<float>(segment % shape.segments) / static_cast<float>(shape.segments);
            const glm::vec3 normal = std::cos(2.0f * pi * turns) * across + std::sin(2.0f * pi * turns) * up;
            const float radius = shape.radii[shape.radii.size() == 1 ? 0 : i];
            add_vertex(mesh, p[i] + radius * normal, normal, {turns, length});
        }
    }
    const auto row = static_cast<std::uint32_t>(shape.segments) + 1;
    join_grid(mesh, 0, row, static_cast<std::uint32_t>(p.size()));
    add_tube_end(mesh, 0, shape.segments, -tangent(0), false);
    add_tube_end(mesh, row * static_cast<std::uint32_t>(p.size() - 1), shape.segments, tangent(p.size() - 1),
                 true);
    return mesh;
}

scene::Mesh make_leaf(const LeafShape& shape)
{
    scene::Mesh mesh;
    glm::vec3 middle(0.0f);
    for (int i = 0; i <= shape.steps; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(shape.steps);
        const float angle = shape.droop * t;
        const glm::vec3 normal(0.0f, std::cos(angle), std::sin(angle));
        // Wide near the root; the tip keeps some width, so that no triangle is degenerate.
        const float half = 0.5f * shape.width * std::max(std::sin(pi * std::pow(t, 0.7f)), 0.06f);
        const glm::vec3 rise = 0.3f * half * normal;
        add_vertex(mesh, middle + glm::vec3(-half, 0, 0) + rise, normal, {0.0f, t});
        add_vertex(mesh, middle, normal, {0.5f, t});
        add_vertex(mesh, middle + glm::vec3(half, 0, 0) + rise, normal, {1.0f, t});
        middle += shape.length / static_cast<float>(shape.steps) *
                  glm::vec3(0.0f, -std::sin(angle), std::cos(angle));
    }
    for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(shape.steps); ++row)
        for (std::uint32_t column = 0; column < 2; ++column) {
            const std::uint32_t a = row * 3 + column, b = a + 3;
            mesh.triangles.push_back({a, b + 1, a + 1});
            mesh.triangles.push_back({a, b, b + 1});
        }
    return mesh;
}

void append(scene::Mesh& whole, const scene::Mesh& part, const glm::mat4& transform, const glm::vec4& tint)
{
    const std::uint32_t first = count_of(whole);
    const glm::mat3 turn(transform);
    for (std::size_t i = 0; i < part.positions.size(); ++i)
        add_vertex(whole, glm::vec3(transform * glm::vec4(part.positions[i], 1.0f)),
                   glm::normalize(turn * part.normals[i]), part.texcoords[0][i]);
    whole.colors.insert(whole.colors.end(), part.positions.size(), tint);
    for (const glm::uvec3& t : part.triangles)
        whole.triangles.push_back(t + first);
}

} // namespace lambent::kitchen
