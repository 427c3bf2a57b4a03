#include "scene/normals.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace lambent::scene {
namespace {

TEST(Normals, FlatNormalsFollowTheWinding)
{
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 1}, {0, 1, 1}};
    make_flat_normals(mesh);
    ASSERT_EQ(mesh.normals.size(), 9u);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[3], glm::vec3(0, 0, -1));
    EXPECT_EQ(mesh.normals[6], glm::vec3(0, 0, 1)) << "no area: +Z";
    EXPECT_EQ(mesh.triangles[1], glm::uvec3(3, 4, 5));
    EXPECT_EQ(mesh.positions[4], glm::vec3(0, 1, 0));
}

TEST(Normals, TinyTrianglesHaveNormalsToo)
{
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1e-25f, 0, 0}, {0, 0, 1e-25f}};
    mesh.triangles = {{0, 1, 2}};
    make_flat_normals(mesh);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, -1, 0));
}

TEST(Normals, BrokenOnesAreTheAngleWeightedMeanOfTheFaces)
{
    // The corner of a cube, its three faces seen from the vertex at the origin: two triangles make up the
    // face z = 0, one each the faces x = 0 and y = 0. All three have a right angle there and count alike.
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}, {0, 0, -1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    mesh.normals = {{0, 0, 0}, {0, 2, 0}, {0, 0, 3}, {nan, 0, 0}, {1, 0, 0}};
    EXPECT_EQ(repair_normals(mesh), 2u);
    const float third = 1.0f / std::sqrt(3.0f);
    EXPECT_NEAR(mesh.normals[0].x, third, 1e-6f);
    EXPECT_NEAR(mesh.normals[0].y, third, 1e-6f);
    EXPECT_NEAR(mesh.normals[0].z, third, 1e-6f);
    EXPECT_EQ(mesh.normals[1], glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.normals[2], glm::vec3(0, 0, 1));
    EXPECT_NEAR(glm::length(mesh.normals[3]), 1.0f, 1e-6f);
    EXPECT_EQ(mesh.normals[4], glm::vec3(1, 0, 0));
}

TEST(Normals, VeryShortAndVeryLongOnesKeepTheirDirection)
{
    Mesh mesh;
    mesh.positions.assign(3, glm::vec3(0));
    mesh.normals = {{0, 1e-30f, 0}, {0, 0, 3e38f}, {3e38f, 3e38f, 0}};
    EXPECT_EQ(repair_normals(mesh), 0u);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.normals[1], glm::vec3(0, 0, 1));
    EXPECT_NEAR(mesh.normals[2].x, std::sqrt(0.5f), 1e-6f);
}

TEST(Normals, WithoutAnyFaceTheyPointToZ)
{
    Mesh mesh;
    mesh.positions = {{0, 0, 0}};
    mesh.normals = {{0, 0, 0}};
    EXPECT_EQ(repair_normals(mesh), 1u);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
}

} // namespace
} // namespace lambent::scene
