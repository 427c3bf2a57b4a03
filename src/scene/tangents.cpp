#include "scene/tangents.h"

#include "equations/in_double.h"

#include "scene/vertices.h"

#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace lambent::scene {
namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};

// The orientation of a texture on a triangle, and the tangent's w for it.
enum Side : int { upright = 0, mirrored = 1, no_area = 2 };
constexpr std::array<float, 2> w_of_side = {1.0f, -1.0f};

// A unit vector perpendicular to a unit vector.
glm::vec3 any_perpendicular(const glm::vec3& n)
{
    const in_double::vec3 x =
        in_double::orthonormal_frame(
            {static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)})
            .x;
    return {x.x, x.y, x.z};
}

std::vector<glm::vec2> transformed(const std::vector<glm::vec2>& texcoords, const glm::mat3& transform)
{
    std::vector<glm::vec2> result(texcoords);
    if (transform != glm::mat3(1.0f))
        for (glm::vec2& uv : result)
            uv = glm::vec2(transform * glm::vec3(uv, 1.0f));
    return result;
}

// Finds vertices with the same position, normal and texture coordinates, bit for bit.
class Welder {
public:
    Welder(const Mesh& mesh, const std::vector<glm::vec2>& uvs)
        : mesh_(mesh), uvs_(uvs), slots_(std::bit_ceil(mesh.positions.size() * 2 + 1), none)
    {
    }

    std::vector<std::uint32_t> first_of_equals()
    {
        std::vector<std::uint32_t> first(mesh_.positions.size());
        for (std::uint32_t vertex = 0; vertex < first.size(); ++vertex)
            first[vertex] = find_or_add(vertex);
        return first;
    }

private:
    // 0 and -0 are equal: adding 0 makes both 0.
    std::array<std::uint32_t, 8> key(std::uint32_t vertex) const
    {
        const glm::vec3 p = mesh_.positions[vertex] + 0.0f;
        const glm::vec3 n = mesh_.normals[vertex] + 0.0f;
        const glm::vec2 t = uvs_[vertex] + 0.0f;
        const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
        return {bits(p.x), bits(p.y), bits(p.z), bits(n.x), bits(n.y), bits(n.z), bits(t.x), bits(t.y)};
    }

    static std::uint64_t hash(const std::array<std::uint32_t, 8>& key)
    {
        std::uint64_t sum = 0;
        for (const std::uint32_t word : key) {
            sum = (sum ^ word) * 0x9E3779B97F4A7C15u;
            sum ^= sum >> 32;
        }
        return sum;
    }

    std::uint32_t find_or_add(std::uint32_t vertex)
    {
        const auto wanted = key(vertex);
        for (std::size_t slot = hash(wanted) & (slots_.size() - 1);;
             slot = (slot + 1) & (slots_.size() - 1)) {
            if (slots_[slot] == none)
                slots_[slot] = vertex;
            if (slots_[slot] == vertex || key(slots_[slot]) == wanted)
                return slots_[slot];
        }
    }

    const Mesh& mesh_;
    const std::vector<glm::vec2>& uvs_;
    std::vector<std::uint32_t> slots_;
};

struct FaceFrame {
    Side side = no_area;
    glm::vec3 along_u{0.0f}; // the direction in which u grows, unit length
};

FaceFrame face_frame(const Mesh& mesh, const std::vector<glm::vec2>& uvs, glm::uvec3 triangle)
{
    const glm::dvec3 edge1 = glm::dvec3(mesh.positions[triangle.y]) - glm::dvec3(mesh.positions[triangle.x]);
    const glm::dvec3 edge2 = glm::dvec3(mesh.positions[triangle.z]) - glm::dvec3(mesh.positions[triangle.x]);
    const glm::dvec2 uv1 = glm::dvec2(uvs[triangle.y]) - glm::dvec2(uvs[triangle.x]);
    const glm::dvec2 uv2 = glm::dvec2(uvs[triangle.z]) - glm::dvec2(uvs[triangle.x]);
    const double area = uv1.x * uv2.y - uv2.x * uv1.y;
    // The derivative of position with respect to u, times the absolute area in the texture.
    const glm::dvec3 derivative = (edge1 * uv2.y - edge2 * uv1.y) * (area < 0.0 ? -1.0 : 1.0);
    const double length = glm::length(derivative);
    if (area == 0.0 || !(length > 0.0) || !std::isfinite(length) || !std::isfinite(area))
        return {};
    // v counts downwards in the image: a texture that is not mirrored has negative area.
    return {area < 0.0 ? upright : mirrored, glm::vec3(derivative / length)};
}

glm::vec3 project(glm::vec3 v, glm::vec3 normal)
{
    return v - normal * glm::dot(normal, v);
}

glm::vec3 unit_or_zero(glm::vec3 v)
{
    const float length = glm::length(v);
    return length > 1e-12f && std::isfinite(length) ? v / length : glm::vec3(0.0f);
}

// The triangle's angle at a corner, its edges projected onto the plane of the corner's normal.
float projected_angle(const Mesh& mesh, glm::uvec3 triangle, int corner)
{
    const glm::vec3 normal = mesh.normals[triangle[corner]];
    const glm::vec3 here = mesh.positions[triangle[corner]];
    const glm::vec3 left = unit_or_zero(project(mesh.positions[triangle[(corner + 1) % 3]] - here, normal));
    const glm::vec3 right = unit_or_zero(project(mesh.positions[triangle[(corner + 2) % 3]] - here, normal));
    return std::acos(std::clamp(glm::dot(left, right), -1.0f, 1.0f));
}

using Sums = std::array<std::vector<glm::vec3>, 2>; // by side, then by the first of equal vertices

// The contributions of a triangle's three corners to the tangents of their vertices.
using CornerTangents = std::array<glm::vec3, 3>;

CornerTangents corner_tangents(const Mesh& mesh, const FaceFrame& face, glm::uvec3 triangle)
{
    CornerTangents tangents;
    for (int corner = 0; corner < 3; ++corner)
        tangents[static_cast<std::size_t>(corner)] =
            unit_or_zero(project(face.along_u, mesh.normals[triangle[corner]])) *
            projected_angle(mesh, triangle, corner);
    return tangents;
}

// Adds serially: the order of a parallel sum, and with it the last digits, would vary.
Sums sum_corners(const Mesh& mesh, const std::vector<FaceFrame>& faces,
                 const std::vector<std::uint32_t>& first)
{
    std::vector<CornerTangents> tangents(faces.size());
    tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t i) {
        if (faces[i].side != no_area)
            tangents[i] = corner_tangents(mesh, faces[i], mesh.triangles[i]);
    });
    Sums sums;
    sums.fill(std::vector<glm::vec3>(mesh.positions.size(), glm::vec3(0.0f)));
    for (std::size_t i = 0; i < faces.size(); ++i)
        if (faces[i].side != no_area)
            for (std::size_t corner = 0; corner < 3; ++corner)
                sums[static_cast<std::size_t>(faces[i].side)]
                    [first[mesh.triangles[i][static_cast<int>(corner)]]] += tangents[i][corner];
    return sums;
}

// Splits vertices that both sides use: a vertex keeps the side found first, a copy takes the other.
class Splitter {
public:
    explicit Splitter(Mesh& mesh)
        : mesh_(mesh), side_of_(mesh.positions.size(), no_area), copy_of_(mesh.positions.size(), none)
    {
    }

    void assign(const std::vector<FaceFrame>& faces)
    {
        for (std::size_t i = 0; i < faces.size(); ++i)
            if (faces[i].side != no_area)
                for (int corner = 0; corner < 3; ++corner)
                    assign_corner(mesh_.triangles[i][corner], faces[i].side);
        append_copies(mesh_, copied_);
        for (const std::uint32_t vertex : copied_)
            side_of_.push_back(side_of_[vertex] == upright ? mirrored : upright);
    }

    const std::vector<Side>& sides() const { return side_of_; }
    const std::vector<std::uint32_t>& copied() const { return copied_; }

private:
    void assign_corner(std::uint32_t& vertex, Side side)
    {
        if (side_of_[vertex] == no_area)
            side_of_[vertex] = side;
        if (side_of_[vertex] == side)
            return;
        if (copy_of_[vertex] == none) {
            copy_of_[vertex] = static_cast<std::uint32_t>(mesh_.positions.size() + copied_.size());
            copied_.push_back(vertex);
        }
        vertex = copy_of_[vertex];
    }

    Mesh& mesh_;
    std::vector<Side> side_of_;
    std::vector<std::uint32_t> copy_of_;
    std::vector<std::uint32_t> copied_;
};

glm::vec4 finish(glm::vec3 sum, glm::vec3 normal, Side side)
{
    // The sum is perpendicular to the normal up to rounding; a second projection removes that error.
    const glm::vec3 tangent = unit_or_zero(project(unit_or_zero(sum), normal));
    return {tangent == glm::vec3(0.0f) ? any_perpendicular(normal) : tangent,
            w_of_side[static_cast<std::size_t>(side)]};
}

} // namespace

void make_tangents(Mesh& mesh, int set, const glm::mat3& uv_transform)
{
    mesh.tangents.clear();
    const std::vector<glm::vec2> uvs = transformed(mesh.texcoords[set], uv_transform);
    std::vector<std::uint32_t> first = Welder(mesh, uvs).first_of_equals();
    std::vector<FaceFrame> faces(mesh.triangles.size());
    tbb::parallel_for(std::size_t{0}, faces.size(),
                      [&](std::size_t i) { faces[i] = face_frame(mesh, uvs, mesh.triangles[i]); });
    const Sums sums = sum_corners(mesh, faces, first);

    Splitter splitter(mesh);
    splitter.assign(faces);
    for (const std::uint32_t vertex : splitter.copied())
        first.push_back(first[vertex]);
    mesh.tangents.reserve(mesh.positions.size());
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        Side side = splitter.sides()[vertex];
        if (side == no_area)
            side = sums[upright][first[vertex]] == glm::vec3(0.0f) &&
                           sums[mirrored][first[vertex]] != glm::vec3(0.0f)
                       ? mirrored
                       : upright;
        mesh.tangents.push_back(
            finish(sums[static_cast<std::size_t>(side)][first[vertex]], mesh.normals[vertex], side));
    }
}

std::size_t repair_tangents(Mesh& mesh)
{
    std::size_t replaced = 0;
    for (std::size_t vertex = 0; vertex < mesh.tangents.size(); ++vertex) {
        glm::vec4& tangent = mesh.tangents[vertex];
        glm::vec3 direction = unit_or_zero(glm::vec3(tangent));
        if (glm::length(project(direction, mesh.normals[vertex])) < 1e-4f) {
            direction = any_perpendicular(mesh.normals[vertex]);
            ++replaced;
        }
        tangent = glm::vec4(direction, tangent.w < 0.0f ? -1.0f : 1.0f);
    }
    return replaced;
}

} // namespace lambent::scene
