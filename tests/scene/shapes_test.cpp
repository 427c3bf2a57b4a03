#include "scene/builtin/shapes.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace lambent::scene {
namespace {

glm::dvec3 face(const Mesh& mesh, glm::uvec3 t)
{
    const glm::dvec3 a(mesh.positions[t.x]);
    return 0.5 * glm::cross(glm::dvec3(mesh.positions[t.y]) - a, glm::dvec3(mesh.positions[t.z]) - a);
}

TEST(Sphere, TrianglesFaceOutwardsAndHaveArea)
{
    const Mesh mesh = make_sphere(0.5f, 38, 20);
    EXPECT_EQ(mesh.triangles.size(), 1444u);
    double smallest = 1.0;
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 middle =
            glm::dvec3(mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0;
        EXPECT_GT(glm::dot(face(mesh, t), middle), 0.0);
        smallest = std::min(smallest, glm::length(face(mesh, t)));
    }
    EXPECT_GT(smallest, 1e-4);
}

TEST(Sphere, AreaAndVolumeApproachTheSphere)
{
    const Mesh mesh = make_sphere(0.5f, 256, 128);
    double area = 0.0;
    double volume = 0.0;
    for (const glm::uvec3 t : mesh.triangles) {
        area += glm::length(face(mesh, t));
        volume += glm::dot(face(mesh, t), glm::dvec3(mesh.positions[t.x])) / 3.0;
    }
    EXPECT_NEAR(area, std::numbers::pi, 1e-3 * std::numbers::pi);
    EXPECT_NEAR(volume, std::numbers::pi / 6.0, 1e-3 * std::numbers::pi / 6.0);
}

TEST(Sphere, IsClosed)
{
    // By position, every edge is walked once in each direction.
    const Mesh mesh = make_sphere(1.0f, 12, 7);
    using Point = std::tuple<float, float, float>;
    const auto point = [&](std::uint32_t i) {
        const glm::vec3 p = mesh.positions[i];
        return Point(p.x, p.y, p.z);
    };
    std::map<std::pair<Point, Point>, int> edges;
    for (const glm::uvec3 t : mesh.triangles)
        for (int i = 0; i < 3; ++i)
            ++edges[{point(t[i]), point(t[(i + 1) % 3])}];
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
}

TEST(Sphere, NormalsAndTextureCoordinatesAreThoseOfTheGlobe)
{
    const Mesh mesh = make_sphere(2.0f, 64, 32);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        EXPECT_NEAR(glm::length(mesh.positions[i] - 2.0f * mesh.normals[i]), 0.0f, 1e-6f);
        EXPECT_NEAR(glm::length(mesh.normals[i]), 1.0f, 1e-6f);
        const glm::vec2 uv = mesh.texcoords[0][i];
        EXPECT_NEAR(mesh.normals[i].y, std::cos(std::numbers::pi * static_cast<double>(uv.y)), 1e-6);
    }
    // In the middle of the image is +Z, and to its right +X.
    const auto at_uv = [&](float u, float v) {
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            if (mesh.texcoords[0][i] == glm::vec2(u, v))
                return mesh.normals[i];
        return glm::vec3(0);
    };
    EXPECT_NEAR(at_uv(0.5f, 0.5f).z, 1.0f, 1e-6f);
    EXPECT_NEAR(at_uv(0.75f, 0.5f).x, 1.0f, 1e-6f);
}

TEST(Plane, LiesFlatAndFacesUp)
{
    const Mesh mesh = make_plane(1.5f, 3);
    EXPECT_EQ(mesh.triangles.size(), 18u);
    double area = 0.0;
    for (const glm::uvec3 t : mesh.triangles) {
        EXPECT_GT(face(mesh, t).y, 0.0);
        area += face(mesh, t).y;
    }
    EXPECT_NEAR(area, 9.0, 1e-5);
    EXPECT_EQ(mesh.positions.front(), glm::vec3(-1.5f, 0, -1.5f));
    EXPECT_EQ(mesh.positions.back(), glm::vec3(1.5f, 0, 1.5f));
    EXPECT_EQ(mesh.texcoords[0].front(), glm::vec2(0, 0));
    EXPECT_EQ(mesh.texcoords[0].back(), glm::vec2(1, 1));
    EXPECT_EQ(mesh.normals[7], glm::vec3(0, 1, 0));
}

} // namespace
} // namespace lambent::scene
