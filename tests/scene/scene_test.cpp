#include "scene/scene.h"
#include "scene/transform.h"

#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>

namespace lambent::scene {
namespace {

// One triangle from the origin to (1, 0, 0) and (0, 2, 3).
Mesh one_triangle()
{
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 3}};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

TEST(Scene, TrianglesAreCountedForEachInstance)
{
    Scene scene;
    scene.meshes = {one_triangle(), one_triangle()};
    scene.meshes[1].triangles.push_back({0, 2, 1});
    scene.instances = {{0, -1, glm::mat4(1.0f)}, {1, -1, glm::mat4(1.0f)}, {1, -1, glm::mat4(1.0f)}};
    EXPECT_EQ(triangle_count(scene), 5u);
    EXPECT_EQ(triangle_count(Scene{}), 0u);
}

TEST(Scene, BoundsAreTightInTheWorld)
{
    Scene scene;
    scene.meshes = {one_triangle()};
    // An eighth of a turn about Z: the box of the turned box would be larger than the box of the points.
    const float half = std::sqrt(0.5f);
    scene.instances = {{0, -1, glm::rotate(glm::mat4(1.0f), glm::radians(45.0f), glm::vec3(0, 0, 1))}};
    const Bounds turned = bounds(scene);
    EXPECT_NEAR(turned.low.x, -2.0f * half, 1e-6f);
    EXPECT_NEAR(turned.high.x, half, 1e-6f);
    EXPECT_NEAR(turned.low.y, 0.0f, 1e-6f);
    EXPECT_NEAR(turned.high.y, 2.0f * half, 1e-6f);
    EXPECT_NEAR(turned.high.z, 3.0f, 1e-6f);
    scene.instances.push_back({0, -1, glm::translate(glm::mat4(1.0f), glm::vec3(10, 0, 0))});
    EXPECT_NEAR(bounds(scene).high.x, 11.0f, 1e-6f);
    EXPECT_NEAR(bounds(scene).low.x, -2.0f * half, 1e-6f);
}

// Four hundred million vertices: their meshes' boxes stand for them. Moved and turned by 45 degrees they reach as far as
// the boxes' corners.
TEST(Scene, BoundsOfManyInstancesAreThoseOfTheirBoxes)
{
    Scene scene;
    scene.meshes = {one_triangle()};
    scene.meshes[0].positions.resize(200'000, glm::vec3(0.5f));
    for (int i = 0; i < 2000; ++i)
        scene.instances.push_back(
            {0, -1, glm::translate(glm::mat4(1.0f), glm::vec3(static_cast<float>(i), 0.0f, 0.0f))});
    EXPECT_EQ(bounds(scene).low, glm::vec3(0.0f));
    EXPECT_EQ(bounds(scene).high, glm::vec3(2000.0f, 2.0f, 3.0f));
    for (Instance& instance : scene.instances)
        instance.transform = glm::rotate(glm::mat4(1.0f), glm::radians(45.0f), glm::vec3(0, 0, 1));
    EXPECT_NEAR(bounds(scene).high.y, 3.0f * std::sqrt(0.5f), 1e-6f);
    EXPECT_NEAR(bounds(scene).low.x, -2.0f * std::sqrt(0.5f), 1e-6f);
}

TEST(Scene, AnEmptySceneHasNoBounds)
{
    const Bounds none = bounds(Scene{});
    EXPECT_GT(none.low.x, none.high.x);
}

TEST(Transform, SingularAndExtremeOnesAreNotInvertible)
{
    const auto scaled = [](double x, double y, double z) {
        return glm::scale(glm::dmat4(1.0), glm::dvec3(x, y, z));
    };
    EXPECT_TRUE(is_invertible(glm::dmat4(1.0)));
    EXPECT_TRUE(is_invertible(scaled(-1, 1, 1)));
    EXPECT_TRUE(is_invertible(scaled(1e-6, 1, 1e6)));
    EXPECT_FALSE(is_invertible(scaled(0, 1, 1)));
    EXPECT_FALSE(is_invertible(scaled(1e-14, 1e-14, 1e-14)));
    EXPECT_FALSE(is_invertible(scaled(1e20, 1e20, 1e20)));
    glm::dmat4 sheared(1.0);
    sheared[1] = sheared[0]; // two axes alike
    EXPECT_FALSE(is_invertible(sheared));
}

} // namespace
} // namespace lambent::scene
