#include "scene/normals.h"

#include "scene/vertices.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace lambent::scene {
namespace {

constexpr glm::vec3 fallback{0.0f, 0.0f, 1.0f};

// In double: the cross product of small edges underflows in float.
glm::dvec3 unit_or_zero(glm::dvec3 v)
{
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3(0.0);
}

glm::dvec3 face_normal(const Mesh& mesh, glm::uvec3 triangle)
{
    const glm::dvec3 a(mesh.positions[triangle.x]);
    return unit_or_zero(
        glm::cross(glm::dvec3(mesh.positions[triangle.y]) - a, glm::dvec3(mesh.positions[triangle.z]) - a));
}

bool normalise(glm::vec3& normal)
{
    const float length = glm::length(normal);
    if (length > 1e-18f && std::isfinite(length)) {
        normal /= length;
        return true;
    }
    const glm::dvec3 unit = unit_or_zero(glm::dvec3(normal));
    normal = glm::vec3(unit);
    return unit != glm::dvec3(0.0);
}

double corner_angle(const Mesh& mesh, glm::uvec3 triangle, int corner)
{
    const auto point = [&](int c) { return glm::dvec3(mesh.positions[triangle[(corner + c) % 3]]); };
    const glm::dvec3 left = unit_or_zero(point(1) - point(0));
    const glm::dvec3 right = unit_or_zero(point(2) - point(0));
    return std::acos(std::clamp(glm::dot(left, right), -1.0, 1.0));
}

void rebuild(Mesh& mesh, const std::vector<bool>& broken)
{
    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
    for (const glm::uvec3 triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner)
            if (broken[triangle[corner]])
                sums[triangle[corner]] += face_normal(mesh, triangle) * corner_angle(mesh, triangle, corner);
    }
    for (std::size_t vertex = 0; vertex < sums.size(); ++vertex) {
        if (!broken[vertex])
            continue;
        const glm::dvec3 unit = unit_or_zero(sums[vertex]);
        mesh.normals[vertex] = unit == glm::dvec3(0.0) ? fallback : glm::vec3(unit);
    }
}

} // namespace

void make_flat_normals(Mesh& mesh)
{
    mesh.normals.clear();
    mesh.tangents.clear();
    split_all_vertices(mesh);
    mesh.normals.reserve(mesh.positions.size());
    for (const glm::uvec3 triangle : mesh.triangles) {
        const glm::dvec3 unit = face_normal(mesh, triangle);
        mesh.normals.insert(mesh.normals.end(), 3, unit == glm::dvec3(0.0) ? fallback : glm::vec3(unit));
    }
}

std::size_t repair_normals(Mesh& mesh)
{
    std::vector<bool> broken;
    std::size_t count = 0;
    for (std::size_t vertex = 0; vertex < mesh.normals.size(); ++vertex) {
        if (normalise(mesh.normals[vertex]))
            continue;
        broken.resize(mesh.normals.size(), false);
        broken[vertex] = true;
        ++count;
    }
    if (count != 0)
        rebuild(mesh, broken);
    return count;
}

} // namespace lambent::scene
