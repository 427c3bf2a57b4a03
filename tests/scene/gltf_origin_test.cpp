// Scenes far from the world's origin are what they are near it.
#include "scene/gltf/gltf.h"
#include "tests/scene/gltf_builder.h"

#include <gtest/gtest.h>

namespace lambent::scene::test {
namespace {

// A triangle, a camera and a lamp under one node that is moved, each off it by eighths of a metre.
GltfBuilder moved(const glm::dvec3& by)
{
    GltfBuilder builder = triangle();
    builder.document["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    builder.document["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    builder.document["nodes"][0]["translation"] = {0.125, 0.25, 0};
    builder.add_node({{"camera", 0}, {"translation", {0, 0, 4.125}}});
    builder.add_node(
        {{"translation", {-1.375, 0, 0}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    builder.add_to("nodes", {{"children", {0, 1, 2}}, {"translation", {by.x, by.y, by.z}}});
    builder.document["scenes"] = {{{"nodes", {3}}}};
    return builder;
}

glm::dvec3 in_world(const Scene& scene, const glm::mat4& transform)
{
    return scene.origin + glm::dvec3(glm::vec3(transform[3]));
}

TEST(GltfOrigin, IsTheWorldsWhereTheSceneIsNear)
{
    for (const double x : {0.0, 10.0, -40.0}) {
        const Scene scene = load(moved({x, 0.0, 0.0}));
        EXPECT_EQ(scene.origin, glm::dvec3(0.0)) << x;
        EXPECT_EQ(in_world(scene, scene.instances.at(0).transform), glm::dvec3(x + 0.125, 0.25, 0.0));
    }
}

// In floats the eighths would be lost: their step is half a metre at 4.5e6 and 8 metres at 1e8.
TEST(GltfOrigin, FollowsASceneThatIsFarAway)
{
    const Scene near = load(moved(glm::dvec3(0.0)));
    for (const glm::dvec3& by :
         {glm::dvec3(4.5e6, 0.0, 0.0), {6.4e5, -5.2e6, 1e3}, {0.0, 1e8, -3e8}, {1e12, 0, 0}}) {
        Warnings warnings;
        const Scene far = load(moved(by), &warnings);
        EXPECT_TRUE(warnings.empty());
        ASSERT_NE(far.origin, glm::dvec3(0.0));
        EXPECT_EQ(in_world(far, far.instances.at(0).transform), by + glm::dvec3(0.125, 0.25, 0.0));
        EXPECT_EQ(in_world(far, far.cameras.at(0).transform), by + glm::dvec3(0.0, 0.0, 4.125));
        EXPECT_EQ(far.origin + glm::dvec3(far.lights.at(0).position), by + glm::dvec3(-1.375, 0.0, 0.0));
        EXPECT_LT(glm::length(far.instances[0].transform[3]), 20.0f);
        // Near enough to the middle, all steps are small: what was between things at the origin still is.
        EXPECT_EQ(far.cameras[0].transform[3] - far.instances[0].transform[3],
                  near.cameras[0].transform[3] - near.instances[0].transform[3]);
    }
}

// A coordinate that floats have, 4.5e6 and half a metre, is brought back by a node.
TEST(GltfOrigin, VerticesFarAwayAreBroughtBackByTheirNode)
{
    GltfBuilder builder;
    builder.add_primitive(
        {{"attributes",
          {{"POSITION", builder.add_vec3({4.5e6f, 0, 0, 4.5e6f + 0.5f, 0, 0, 4.5e6f, 1, 0})}}}});
    builder.document["nodes"][0]["translation"] = {-4.5e6, 0, 0};
    const Scene scene = load(builder);
    EXPECT_EQ(scene.origin, glm::dvec3(0.0));
    EXPECT_EQ(bounds(scene).low, glm::vec3(0.0f));
    EXPECT_EQ(bounds(scene).high, glm::vec3(0.5f, 1.0f, 0.0f));
    builder.document["nodes"][0]["translation"] = {0, 0, 0};
    const Scene there = load(builder);
    EXPECT_EQ(there.origin.x + static_cast<double>(bounds(there).low.x), 4.5e6);
    EXPECT_EQ(there.origin.x + static_cast<double>(bounds(there).high.x), 4.5e6 + 0.5);
}

// Joints are nodes of the world: the skin goes with them.
TEST(GltfOrigin, SkinsFollow)
{
    const auto skinned = [](double x) {
        GltfBuilder builder;
        builder.add_primitive(
            {{"attributes",
              {{"POSITION", builder.add_vec3({0, 0, 0, 1.125f, 0, 0, 0, 1, 0})},
               {"JOINTS_0", builder.add<std::uint8_t>("VEC4", u8, {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0})},
               {"WEIGHTS_0", builder.add_vec4({0.5f, 0.5f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0})}}}});
        const int first = builder.add_node({{"translation", {x, 0, 0}}});
        const int second = builder.add_node({{"translation", {x, 2, 0}}});
        builder.document["skins"] = {{{"joints", {first, second}}}};
        builder.document["nodes"][0]["skin"] = 0;
        return load(builder);
    };
    const Scene near = skinned(0.0), far = skinned(4.5e6);
    EXPECT_EQ(near.origin, glm::dvec3(0.0));
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(far.origin + glm::dvec3(far.meshes[0].positions[i]),
                  glm::dvec3(4.5e6, 0.0, 0.0) + glm::dvec3(near.meshes[0].positions[i]));
}

// Every moment is seen from the origin of the scene at rest.
TEST(GltfOrigin, StaysWhileThingsMove)
{
    GltfBuilder builder = moved({4.5e6, 0.0, 0.0});
    const int times = builder.add("SCALAR", f32, std::vector<float>{0, 1});
    builder.document["accessors"][static_cast<std::size_t>(times)]["min"] = {0};
    builder.document["accessors"][static_cast<std::size_t>(times)]["max"] = {1};
    builder.document["animations"] = {
        {{"samplers", {{{"input", times}, {"output", builder.add_vec3({0, 0, 0, 3.25f, 0, 0})}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
    const Bytes bytes = builder.glb();
    Warnings warnings;
    const GltfFile file(GltfSource{"test.glb", bytes, {}}, warnings);
    const Scene rest = file.scene(std::nullopt, warnings), end = file.scene(Moment{0, 1.0}, warnings),
                pose = file.pose({0, 1.0});
    for (const Scene* scene : {&end, &pose}) {
        EXPECT_EQ(scene->origin, rest.origin);
        EXPECT_EQ(in_world(*scene, scene->instances.at(0).transform), glm::dvec3(4.5e6 + 3.25, 0.0, 0.0));
        ASSERT_TRUE(scene->rest_bounds);
        EXPECT_EQ(scene->rest_bounds->low, bounds(rest).low);
    }
}

TEST(GltfOrigin, IsInStepsOfTheScenesSize)
{
    EXPECT_EQ(better_origin({}), glm::dvec3(0.0));
    EXPECT_EQ(better_origin({glm::vec3(63.0f, 0.0f, 0.0f), glm::vec3(65.0f, 0.0f, 0.0f)}), glm::dvec3(0.0));
    EXPECT_EQ(better_origin({glm::vec3(64.0f, 0.0f, 0.0f), glm::vec3(66.0f, 0.0f, 0.0f)}),
              glm::dvec3(65.0, 0.0, 0.0));
    EXPECT_EQ(better_origin({glm::vec3(1000.0f, 2.0f, 0.0f), glm::vec3(1006.0f, 2.0f, 0.0f)}),
              glm::dvec3(1004.0, 4.0, 0.0));
    EXPECT_EQ(better_origin({glm::vec3(7.0f), glm::vec3(7.0f)}), glm::dvec3(7.0)); // one point
}

} // namespace
} // namespace lambent::scene::test
