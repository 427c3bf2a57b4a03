// EXT_mesh_gpu_instancing: where instances stand, by hand, and what files do wrong.
#include "scene/gltf/gltf.h"
#include "tests/scene/gltf_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lambent::scene::test {
namespace {

constexpr float root_half = 0.70710678f;

json& attributes_of(GltfBuilder& builder, std::size_t node = 0)
{
    return builder.document["nodes"][node]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
}

glm::vec3 moved(const Scene& scene, std::size_t instance, const glm::vec3& point)
{
    return glm::vec3(scene.instances.at(instance).transform * glm::vec4(point, 1.0f));
}

void expect_near(const glm::vec3& a, const glm::vec3& b, float slack = 1e-5f)
{
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(a[i], b[i], slack) << "component " << i;
}

// World from mesh is the node's transform times T * R * S.
TEST(GltfInstancing, TransformsAreTheNodesTimesTheInstances)
{
    GltfBuilder builder = triangle();
    builder.document["nodes"][0]["translation"] = {100, 0, 0};
    builder.document["nodes"][0]["scale"] = {2, 2, 2};
    attributes_of(builder) = {{"TRANSLATION", builder.add_vec3({1, 2, 3, 0, 0, 0})},
                              {"ROTATION", builder.add_vec4({0, 0, 0, 1, 0, 0, root_half, root_half})},
                              {"SCALE", builder.add_vec3({1, 1, 1, 3, 1, 1})},
                              {"_ID", builder.add<std::uint16_t>("SCALAR", u16, {7, 8})}};
    builder.document["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
    builder.document["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    Warnings warnings;
    const Scene scene = load(builder, &warnings);
    EXPECT_EQ(warnings, Warnings());
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.meshes.size(), 1u);
    expect_near(moved(scene, 0, {1, 0, 0}), {104, 4, 6}, 1e-4f);
    // Three times as long, turned from X to Y, then twice as large.
    expect_near(moved(scene, 1, {1, 0, 0}), {100, 6, 0}, 1e-4f);
    expect_near(moved(scene, 1, {0, 1, 0}), {98, 0, 0}, 1e-4f);
}

// 90 / 127 and 23170 / 32767 are root_half to a hundredth and to 1e-5; lengths are mended.
TEST(GltfInstancing, RotationsMayBeNormalizedIntegers)
{
    GltfBuilder builder = triangle();
    attributes_of(builder) = {{"ROTATION", builder.add<std::int8_t>("VEC4", i8, {0, 0, 90, 90}, true)}};
    expect_near(moved(load(builder), 0, {1, 0, 0}), {0, 1, 0});
    attributes_of(builder) = {
        {"ROTATION", builder.add<std::int16_t>("VEC4", i16, {0, 23170, 0, 23170}, true)}};
    expect_near(moved(load(builder), 0, {1, 0, 0}), {0, 0, -1});
    // Exporters that forget to say so mean the same.
    attributes_of(builder) = {{"ROTATION", builder.add<std::int8_t>("VEC4", i8, {0, 0, -128, -127})}};
    expect_near(moved(load(builder), 0, {1, 0, 0}), {0, 1, 0});
}

TEST(GltfInstancing, MeshesOfSeveralPrimitivesAreSharedWithOtherNodes)
{
    GltfBuilder builder = triangle();
    json& primitives = builder.document["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
    builder.add_node({{"mesh", 0}});
    attributes_of(builder) = {{"TRANSLATION", builder.add_vec3({1, 0, 0, 2, 0, 0, 3, 0, 0})}};
    const Scene scene = load(builder);
    EXPECT_EQ(scene.meshes.size(), 2u);
    ASSERT_EQ(scene.instances.size(), 8u);
    EXPECT_EQ(scene.instances[4].transform[3].x, 3.0f);
    EXPECT_EQ(scene.instances[6].transform[3].x, 0.0f);
}

// What is wrong costs instances, or what they differ by, never the file.
TEST(GltfInstancing, BrokenPartsAreNamedAndLeftOut)
{
    Warnings warnings;
    GltfBuilder builder = triangle();
    const int three = builder.add_vec3({1, 0, 0, 2, 0, 0, 3, 0, 0}),
              two = builder.add_vec3({1, 1, 1, 1, 1, 1});
    attributes_of(builder) = {{"TRANSLATION", three}, {"SCALE", two}};
    EXPECT_EQ(load(builder, &warnings).instances.size(), 2u);
    EXPECT_TRUE(warned_once(warnings, "node 0, EXT_mesh_gpu_instancing: attributes of 2 and of 3 elements"));

    for (const json& broken : {json{{"TRANSLATION", 99}}, json{{"ROTATION", three}}, json{{"_ID", 99}}}) {
        attributes_of(builder) = broken;
        warnings.clear();
        const Scene scene = load(builder, &warnings);
        ASSERT_EQ(scene.instances.size(), 1u) << broken;
        EXPECT_EQ(scene.instances[0].transform, glm::mat4(1.0f));
        EXPECT_TRUE(warned_once(warnings, "the mesh is drawn once")) << broken;
        EXPECT_TRUE(contains(warnings.at(0), "node 0, EXT_mesh_gpu_instancing")) << broken;
    }

    constexpr float infinite = std::numeric_limits<float>::infinity();
    attributes_of(builder) = {
        {"TRANSLATION", builder.add_vec3({0, 0, 0, infinite, 0, 0, 1e30f, 0, 0, 4, 0, 0, 5, 0, 0})},
        {"ROTATION", builder.add_vec4({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1})},
        {"SCALE", builder.add_vec3({0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1})}};
    warnings.clear();
    const Scene scene = load(builder, &warnings);
    ASSERT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(scene.instances[0].transform[3].x, 5.0f);
    EXPECT_TRUE(
        warned_once(warnings, "4 instances of EXT_mesh_gpu_instancing are flat, not finite or too far away"));

    attributes_of(builder) = json::object();
    warnings.clear();
    EXPECT_EQ(load(builder, &warnings).instances.size(), 1u);
    EXPECT_EQ(warnings, Warnings());
}

TEST(GltfInstancing, FaultsOfManyNodesAreOneLine)
{
    GltfBuilder builder = triangle();
    attributes_of(builder) = {{"TRANSLATION", 99}};
    for (std::size_t node = 1; node < 100; ++node) {
        builder.add_node({{"mesh", 0}});
        attributes_of(builder, node) = {{"TRANSLATION", 99}};
    }
    EXPECT_EQ(load(builder).instances.size(), 100u);
    EXPECT_EQ(complaint(builder), "test.gltf: node 0, EXT_mesh_gpu_instancing, TRANSLATION: accessor 99 does "
                                  "not exist: the mesh is drawn once (and 99 more like it)");
    // An attribute that is no accessor's number is not there, as the file's schema is read.
    GltfBuilder other = triangle();
    attributes_of(other) = {{"TRANSLATION", other.add_vec3({1, 0, 0, 2, 0, 0})}, {"SCALE", "large"}};
    EXPECT_EQ(load(other).instances.size(), 2u);
    EXPECT_TRUE(contains(complaint(other), "SCALE is not a whole number"));
}

// A file without bytes may not ask for gigabytes.
TEST(GltfInstancing, SmallFilesMayNotAskForMillions)
{
    GltfBuilder builder = triangle();
    builder.document["accessors"].push_back({{"componentType", f32}, {"type", "VEC3"}, {"count", 1'000'000}});
    const std::size_t zeros = builder.document["accessors"].size() - 1;
    builder.add_node({{"mesh", 0}});
    for (std::size_t node : {0u, 1u})
        attributes_of(builder, node) = {{"TRANSLATION", zeros}};
    Warnings warnings;
    EXPECT_LE(load(builder, &warnings).instances.size(), 100'100u);
    EXPECT_TRUE(warned_once(warnings, "node 0, EXT_mesh_gpu_instancing: 1000000 instances: only 1000"));
    EXPECT_TRUE(contains(warnings.at(0), "of them are drawn (and 1 more like it)")) << "none of node 1's";
}

// Its joints place a skinned mesh; each instance moves it from there, and its node does not.
GltfBuilder skinned(const std::vector<double>& joint_at)
{
    GltfBuilder builder;
    const int positions = builder.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0}),
              joints = builder.add<std::uint8_t>("VEC4", u8, std::vector<std::uint8_t>(12, 0)),
              weights = builder.add_vec4({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    builder.add_primitive(
        {{"attributes", {{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}}});
    json& node = builder.document["nodes"][0];
    node["skin"] = 0;
    node["translation"] = {0, 0, 50};
    const int joint = builder.add_node({{"translation", joint_at}});
    builder.document["skins"] = json::array({{{"joints", {joint}}}});
    return builder;
}

TEST(GltfInstancing, SkinnedMeshesAreMovedFromWhereTheirJointsHaveThem)
{
    GltfBuilder builder = skinned({0, 7, 0});
    attributes_of(builder) = {{"TRANSLATION", builder.add_vec3({1, 0, 0, 2, 0, 0})}};
    const Scene scene = load(builder);
    ASSERT_EQ(scene.instances.size(), 2u);
    expect_near(moved(scene, 1, scene.meshes.at(0).positions[0]), {2, 7, 0});
}

// A quarter of a turn about +Y, about the world's origin, however far the skin is: (x, y, z) comes to (z, y, -x).
TEST(GltfInstancing, SkinnedMeshesFarAwayTurnAboutTheWorldsOrigin)
{
    GltfBuilder builder = skinned({4.5e6, 7, 0});
    const float half = std::sqrt(0.5f);
    attributes_of(builder) = {{"ROTATION", builder.add_vec4({0, half, 0, half})}};
    const Scene scene = load(builder);
    ASSERT_EQ(scene.instances.size(), 1u);
    const glm::dvec3 place = scene.origin + glm::dvec3(moved(scene, 0, scene.meshes.at(0).positions[0]));
    // The rotation is given in floats: it is off by up to 1e-7 of the distance.
    EXPECT_NEAR(place.x, 0.0, 1.0);
    EXPECT_NEAR(place.y, 7.0, 1e-3);
    EXPECT_NEAR(place.z, -4.5e6, 1.0);
}

// From x = 0 to x = 10 in a second; the instance without size is kept, out of sight, at every moment.
TEST(GltfInstancing, InstancesGoWithTheirNode)
{
    GltfBuilder builder = triangle();
    attributes_of(builder) = {{"TRANSLATION", builder.add_vec3({1, 0, 0, 2, 0, 0})},
                              {"SCALE", builder.add_vec3({1, 1, 1, 0, 0, 0})}};
    const int times = builder.add("SCALAR", f32, std::vector<float>{0, 1}),
              places = builder.add_vec3({0, 0, 0, 10, 0, 0});
    builder.document["animations"] = json::array(
        {{{"samplers", json::array({{{"input", times}, {"output", places}}})},
          {"channels",
           json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}})}}});
    const Bytes bytes = builder.glb();
    Warnings warnings;
    const GltfFile file({"test.gltf", bytes, std::nullopt, {}}, warnings);
    const Scene rest = file.scene(std::nullopt, warnings), half = file.pose({0, 0.5});
    ASSERT_EQ(rest.instances.size(), 2u);
    ASSERT_EQ(half.instances.size(), 2u);
    EXPECT_EQ(half.instances[0].transform[3].x, 6.0f);
    EXPECT_TRUE(is_empty(half.meshes.at(static_cast<std::size_t>(half.instances[1].mesh))));
}

} // namespace
} // namespace lambent::scene::test
