// The witness: on a surface given by a formula, the tangent is the derivative of position by u, and the
// bitangent points where v shrinks.
#include "scene/tangents.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <cmath>
#include <numbers>

namespace lambent::scene {
namespace {

// A square of four vertices facing +Z with an image upright on it.
Mesh upright_square()
{
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.texcoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

void expect_near(glm::vec3 a, glm::vec3 b, float bound)
{
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(a[i], b[i], bound) << "component " << i;
}

glm::vec3 bitangent(const Mesh& mesh, std::size_t vertex)
{
    return glm::cross(mesh.normals[vertex], glm::vec3(mesh.tangents[vertex])) * mesh.tangents[vertex].w;
}

TEST(Tangents, AnUprightImageHasTangentRightAndBitangentUp)
{
    Mesh mesh = upright_square();
    make_tangents(mesh, 0, glm::mat3(1.0f));
    ASSERT_EQ(mesh.tangents.size(), 4u);
    for (std::size_t vertex = 0; vertex < 4; ++vertex) {
        EXPECT_EQ(mesh.tangents[vertex], glm::vec4(1, 0, 0, 1));
        expect_near(bitangent(mesh, vertex), {0, 1, 0}, 1e-6f);
    }
}

TEST(Tangents, AMirroredImageHasTangentLeftAndBitangentStillUp)
{
    Mesh mesh = upright_square();
    for (glm::vec2& uv : mesh.texcoords[0])
        uv.x = 1.0f - uv.x;
    make_tangents(mesh, 0, glm::mat3(1.0f));
    for (std::size_t vertex = 0; vertex < 4; ++vertex) {
        EXPECT_EQ(mesh.tangents[vertex], glm::vec4(-1, 0, 0, -1));
        expect_near(bitangent(mesh, vertex), {0, 1, 0}, 1e-6f);
    }
}

TEST(Tangents, TheTextureTransformTurnsTheFrame)
{
    // u' = v, v' = -u: the image's right now lies where v grew, downwards; its up where u grew, to the right.
    Mesh mesh = upright_square();
    const glm::mat3 transform({0, -1, 0}, {1, 0, 0}, {0, 0, 1});
    make_tangents(mesh, 0, transform);
    for (std::size_t vertex = 0; vertex < 4; ++vertex) {
        expect_near(glm::vec3(mesh.tangents[vertex]), {0, -1, 0}, 1e-6f);
        expect_near(bitangent(mesh, vertex), {1, 0, 0}, 1e-6f);
    }
}

TEST(Tangents, VerticesOnAMirrorSeamAreSplit)
{
    // A second square to the right whose image is mirrored: they share the vertices at x = 1.
    Mesh mesh = upright_square();
    mesh.positions.insert(mesh.positions.end(), {{3, -1, 0}, {3, 1, 0}});
    mesh.normals.insert(mesh.normals.end(), 2, {0, 0, 1});
    mesh.texcoords[0].insert(mesh.texcoords[0].end(), {{0, 1}, {0, 0}});
    mesh.colors = {{1, 0, 0, 1}, {2, 0, 0, 1}, {3, 0, 0, 1}, {4, 0, 0, 1}, {5, 0, 0, 1}, {6, 0, 0, 1}};
    mesh.triangles.insert(mesh.triangles.end(), {{1, 4, 5}, {1, 5, 2}});
    make_tangents(mesh, 0, glm::mat3(1.0f));
    ASSERT_EQ(mesh.positions.size(), 8u);
    ASSERT_EQ(mesh.tangents.size(), 8u);
    ASSERT_EQ(mesh.colors.size(), 8u);
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::vec4 expected = i < 2 ? glm::vec4(1, 0, 0, 1) : glm::vec4(-1, 0, 0, -1);
        for (int corner = 0; corner < 3; ++corner)
            EXPECT_EQ(mesh.tangents[mesh.triangles[i][corner]], expected) << "triangle " << i;
    }
    const std::uint32_t shared = mesh.triangles[2].x;
    EXPECT_EQ(mesh.positions[shared], glm::vec3(1, -1, 0));
    EXPECT_EQ(mesh.colors[shared].x, 2.0f);
}

TEST(Tangents, EqualVerticesAreAveragedWhetherIndexedOrNot)
{
    // A roof whose ridge lies along Y, both sides with one normal at the ridge; u runs over the roof.
    Mesh indexed;
    indexed.positions = {{-1, 0, 0}, {0, 0, 1}, {0, 1, 1}, {-1, 1, 0}, {1, 0, 0}, {1, 1, 0}};
    indexed.normals = {{-0.6f, 0, 0.8f}, {0, 0, 1},       {0, 0, 1},
                       {-0.6f, 0, 0.8f}, {0.6f, 0, 0.8f}, {0.6f, 0, 0.8f}};
    indexed.texcoords[0] = {{0, 1}, {0.5f, 1}, {0.5f, 0}, {0, 0}, {1, 1}, {1, 0}};
    indexed.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
    Mesh loose;
    for (glm::uvec3& triangle : indexed.triangles) {
        const auto first = static_cast<std::uint32_t>(loose.positions.size());
        for (int corner = 0; corner < 3; ++corner) {
            loose.positions.push_back(indexed.positions[triangle[corner]]);
            loose.normals.push_back(indexed.normals[triangle[corner]]);
            loose.texcoords[0].push_back(indexed.texcoords[0][triangle[corner]]);
        }
        loose.triangles.push_back({first, first + 1, first + 2});
    }
    make_tangents(indexed, 0, glm::mat3(1.0f));
    make_tangents(loose, 0, glm::mat3(1.0f));
    EXPECT_EQ(indexed.positions.size(), 6u);
    expect_near(glm::vec3(indexed.tangents[1]), {1, 0, 0},
                1e-6f); // on the ridge, perpendicular to its normal
    expect_near(glm::vec3(indexed.tangents[0]), {0.8f, 0, 0.6f}, 1e-6f);
    for (std::size_t i = 0; i < indexed.triangles.size(); ++i)
        for (int corner = 0; corner < 3; ++corner)
            expect_near(glm::vec3(indexed.tangents[indexed.triangles[i][corner]]),
                        glm::vec3(loose.tangents[loose.triangles[i][corner]]), 1e-6f);
}

TEST(Tangents, CornersCountByTheirAngle)
{
    // Two triangles meet at the origin in the plane z = 0, with tangents along +X and +Y; their angles there
    // are 90 and 45 degrees. The sum is 2 (1, 0, 0) + 1 (0, 1, 0).
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
    mesh.normals.assign(5, {0, 0, 1});
    // First: u = x, v = -y. Second: u = y, v = x; the first corner has coordinates (0, 0) in both.
    mesh.texcoords[0] = {{0, 0}, {1, 0}, {0, -1}, {0, -1}, {-1, -1}};
    mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
    make_tangents(mesh, 0, glm::mat3(1.0f));
    expect_near(glm::vec3(mesh.tangents[0]), glm::vec3(2, 1, 0) / std::sqrt(5.0f), 1e-5f);
}

TEST(Tangents, OnATorusTheyAreTheDerivativeByU)
{
    constexpr int around = 96;
    constexpr int across = 48;
    constexpr double turn = 2.0 * std::numbers::pi;
    Mesh mesh;
    std::vector<glm::vec3> by_u;
    for (int i = 0; i <= around; ++i) {
        for (int j = 0; j <= across; ++j) {
            const double u = static_cast<double>(i) / around;
            const double v = static_cast<double>(j) / across;
            const double a = turn * u;
            const double b = -turn * v; // v runs clockwise: the image stands upright seen from outside
            const double r = 2.0 + 0.5 * std::cos(b);
            mesh.positions.push_back(glm::vec3(r * std::cos(a), r * std::sin(a), 0.5 * std::sin(b)));
            mesh.normals.push_back(
                glm::vec3(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b)));
            mesh.texcoords[1].push_back(glm::vec2(u, v));
            by_u.push_back(glm::vec3(-std::sin(a), std::cos(a), 0.0));
        }
    }
    for (unsigned i = 0; i < around; ++i) {
        for (unsigned j = 0; j < across; ++j) {
            const unsigned a = i * (across + 1) + j;
            mesh.triangles.push_back({a, a + across + 2, a + across + 1});
            mesh.triangles.push_back({a, a + 1, a + across + 2});
        }
    }
    for (glm::uvec3& t : mesh.triangles) // the outside is counter-clockwise
        if (glm::dot(glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                mesh.positions[t.z] - mesh.positions[t.x]),
                     mesh.normals[t.x]) < 0.0f)
            std::swap(t.y, t.z);
    make_tangents(mesh, 1, glm::mat3(1.0f));
    ASSERT_EQ(mesh.tangents.size(), by_u.size());
    for (std::size_t vertex = 0; vertex < by_u.size(); ++vertex) {
        // A vertex of the seam sees triangles on one side only: its tangent is off by half a segment.
        expect_near(glm::vec3(mesh.tangents[vertex]), by_u[vertex], 0.04f);
        EXPECT_EQ(mesh.tangents[vertex].w, 1.0f);
        EXPECT_NEAR(glm::dot(glm::vec3(mesh.tangents[vertex]), mesh.normals[vertex]), 0.0f, 1e-6f);
        EXPECT_NEAR(glm::length(glm::vec3(mesh.tangents[vertex])), 1.0f, 1e-6f);
    }
}

TEST(Tangents, TrianglesWithoutTextureAreaTakeAFrameAnyway)
{
    Mesh mesh = upright_square();
    mesh.positions.push_back({-1, 3, 0});
    mesh.normals.push_back({0, 0, 1});
    mesh.texcoords[0].push_back(mesh.texcoords[0][3]);
    mesh.triangles.push_back({3, 2, 4}); // two corners with the same texture coordinates
    mesh.triangles.push_back({4, 4, 4});
    make_tangents(mesh, 0, glm::mat3(1.0f));
    ASSERT_EQ(mesh.tangents.size(), 5u);
    EXPECT_EQ(mesh.tangents[2], glm::vec4(1, 0, 0, 1)) << "of the neighbour";
    EXPECT_NEAR(glm::length(glm::vec3(mesh.tangents[4])), 1.0f, 1e-6f);
    EXPECT_NEAR(mesh.tangents[4].z, 0.0f, 1e-6f);

    for (glm::vec2& uv : mesh.texcoords[0])
        uv = glm::vec2(0.5f);
    make_tangents(mesh, 0, glm::mat3(1.0f));
    for (const glm::vec4& tangent : mesh.tangents)
        EXPECT_NEAR(glm::length(glm::vec3(tangent)), 1.0f, 1e-6f);
}

TEST(Tangents, GivenOnesAlongTheNormalAreReplaced)
{
    Mesh mesh = upright_square();
    mesh.normals = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}};
    mesh.tangents = {{0, 0, 4, 1}, {0, 0, 1, -1}, {0, 0, 0, 1}, {0.5f, 0, 0, -0.1f}};
    EXPECT_EQ(repair_tangents(mesh), 3u);
    for (std::size_t vertex = 0; vertex < 4; ++vertex) {
        EXPECT_NEAR(glm::length(glm::vec3(mesh.tangents[vertex])), 1.0f, 1e-6f);
        EXPECT_NEAR(glm::dot(glm::vec3(mesh.tangents[vertex]), mesh.normals[vertex]), 0.0f, 1e-6f);
    }
    EXPECT_EQ(mesh.tangents[1].w, -1.0f);
    EXPECT_EQ(mesh.tangents[3], glm::vec4(1, 0, 0, -1));
}

} // namespace
} // namespace lambent::scene
