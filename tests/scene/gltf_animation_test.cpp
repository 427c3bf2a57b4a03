// Animations, against values worked out by hand and closed forms.
#include "scene/gltf/gltf.h"
#include "scene/gltf/gltf_curve.h"
#include "tests/scene/gltf_builder.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace lambent::scene::test {
namespace {

constexpr float root_half = 0.70710678f;
constexpr float infinite = std::numeric_limits<float>::infinity();

// Adds an animation, if there is none, and to it a sampler with a channel.
void animate(GltfBuilder& builder, int node, const char* path, int input, int output,
             const char* interpolation = "LINEAR")
{
    json& animations = builder.document["animations"];
    if (animations.empty())
        animations.push_back({{"channels", json::array()}, {"samplers", json::array()}});
    json& animation = animations[0];
    animation["channels"].push_back(
        {{"sampler", animation["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    animation["samplers"].push_back({{"input", input}, {"output", output}, {"interpolation", interpolation}});
}

int add_times(GltfBuilder& builder, const std::vector<float>& times)
{
    return builder.add("SCALAR", f32, times);
}

// A triangle that goes from x = 1 to x = 3 between 1 s and 3 s.
GltfBuilder moving_triangle(const char* interpolation = "LINEAR")
{
    GltfBuilder builder = triangle();
    animate(builder, 0, "translation", add_times(builder, {1, 3}), builder.add_vec3({1, 0, 0, 3, 0, 0}),
            interpolation);
    return builder;
}

// What stays of a file while its bytes do.
class Opened {
public:
    explicit Opened(const GltfBuilder& builder)
        : bytes_(builder.glb()), file_({"test.gltf", bytes_, std::nullopt}, warnings)
    {
    }

    Scene at(double seconds, int animation = 0) const { return file_.pose({animation, seconds}); }
    const GltfFile& file() const { return file_; }

    Warnings warnings;

private:
    Bytes bytes_;
    GltfFile file_;
};

glm::vec3 place(const Scene& scene, std::size_t instance = 0)
{
    return glm::vec3(scene.instances.at(instance).transform[3]);
}

void expect_near(const glm::vec3& found, const glm::vec3& wanted)
{
    EXPECT_LE(glm::length(found - wanted), 2e-6f) << found.x << ' ' << found.y << ' ' << found.z << ", not "
                                                  << wanted.x << ' ' << wanted.y << ' ' << wanted.z;
}

TEST(GltfAnimation, IsListedWithItsDuration)
{
    GltfBuilder builder = moving_triangle();
    const json unnamed = builder.document["animations"][0];
    builder.document["animations"][0]["name"] = "walk";
    builder.document["animations"].push_back(unnamed);
    const Opened opened(builder);
    ASSERT_EQ(opened.file().animations().size(), 2u);
    EXPECT_EQ(opened.file().animations()[0].name, "walk");
    EXPECT_EQ(opened.file().animations()[0].seconds, 3.0);
    EXPECT_EQ(opened.file().animations()[1].name, "animation1");
    EXPECT_TRUE(opened.warnings.empty());
    const Scene still = load(builder);
    EXPECT_EQ(still.animations.size(), 2u);
    EXPECT_FALSE(still.rest_bounds.has_value());
    EXPECT_EQ(place(still), glm::vec3(0));
}

TEST(GltfAnimation, LinearGoesStraightAndIsHeldAtItsEnds)
{
    const Opened opened(moving_triangle());
    for (const auto& [seconds, x] : {std::pair(-5.0, 1.0f),
                                     {0.0, 1.0f},
                                     {1.0, 1.0f},
                                     {1.5, 1.5f},
                                     {2.75, 2.75f},
                                     {3.0, 3.0f},
                                     {1e9, 3.0f}})
        expect_near(place(opened.at(seconds)), {x, 0, 0});
    expect_near(place(opened.at(std::numeric_limits<double>::quiet_NaN())), {1, 0, 0});
}

TEST(GltfAnimation, StepWaitsForTheNextKey)
{
    const Opened opened(moving_triangle("STEP"));
    for (const auto& [seconds, x] : {std::pair(0.0, 1.0f), {2.999, 1.0f}, {3.0, 3.0f}, {4.0, 3.0f}})
        expect_near(place(opened.at(seconds)), {x, 0, 0});
}

TEST(GltfAnimation, CubicIsHermitesOverSeconds)
{
    // Between values 1 and 5, two seconds apart, with slopes 3 and -1 a second, at half: by hand
    // (1 + 5) / 2 + 2 / 8 (3 - -1) = 4; a quarter of the way: 0.84375 * 1 + 0.15625 * 5 + 2 (0.140625 * 3 + 0.046875).
    GltfBuilder builder = triangle();
    animate(builder, 0, "translation", add_times(builder, {1, 3}),
            builder.add_vec3({9, 9, 9, 1, 0, 0, 3, 0, 0, -1, 0, 0, 5, 0, 0, 9, 9, 9}), "CUBICSPLINE");
    const Opened opened(builder);
    expect_near(place(opened.at(0.0)), {1, 0, 0});
    expect_near(place(opened.at(1.5)), {2.5625f, 0, 0});
    expect_near(place(opened.at(2.0)), {4, 0, 0});
    expect_near(place(opened.at(9.0)), {5, 0, 0});
}

TEST(GltfAnimation, RotationsTakeEqualAnglesInEqualTimes)
{
    // A quarter turn about z in one second: x becomes (cos, sin) of the time's part of it.
    for (const float sign : {1.0f, -1.0f}) { // of a quaternion that is the same rotation
        GltfBuilder builder = triangle();
        animate(builder, 0, "rotation", add_times(builder, {0, 1}),
                builder.add_vec4({0, 0, 0, 1, 0, 0, sign * root_half, sign * root_half}));
        const Opened opened(builder);
        for (const double t : {0.0, 0.125, 0.5, 0.8, 1.0}) {
            const double angle = t * std::numbers::pi / 2.0;
            expect_near(glm::vec3(opened.at(t).instances[0].transform[0]),
                        {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0});
        }
    }
}

TEST(GltfAnimation, CubicRotationsAreNormalised)
{
    // Halfway without tangents: the mean of the two, (0, 0, r, 1 + r) / 2, whose direction is an eighth of a turn.
    GltfBuilder builder = triangle();
    animate(builder, 0, "rotation", add_times(builder, {0, 1}),
            builder.add_vec4({0, 0, 0, 0, 0, 0, 0,         1,         0, 0, 0, 0, //
                              0, 0, 0, 0, 0, 0, root_half, root_half, 0, 0, 0, 0}),
            "CUBICSPLINE");
    const Opened opened(builder);
    expect_near(glm::vec3(opened.at(0.5).instances[0].transform[0]), {root_half, root_half, 0});
}

TEST(GltfAnimation, ScaleAndTheOtherPropertiesGoTogether)
{
    GltfBuilder builder = moving_triangle();
    builder.document["nodes"][0]["rotation"] = {0, 0, root_half, root_half}; // stays
    animate(builder, 0, "scale", add_times(builder, {0, 2}), builder.add_vec3({1, 1, 1, 3, 5, 7}));
    const glm::mat4 m = Opened(builder).at(1.0).instances[0].transform;
    expect_near(glm::vec3(m[0]), {0, 2, 0});
    expect_near(glm::vec3(m[1]), {-3, 0, 0});
    expect_near(glm::vec3(m[2]), {0, 0, 4});
    expect_near(glm::vec3(m[3]), {1, 0, 0});
}

TEST(GltfAnimation, WholeNumbersAreFractions)
{
    // 16-bit: 23170 / 32767 is the sine of 45 degrees; 8-bit weights: 51 / 255 is a fifth.
    GltfBuilder builder = triangle();
    json& primitive = builder.document["meshes"][0]["primitives"][0];
    primitive["targets"] = {{{"POSITION", builder.add_vec3({10, 0, 0, 0, 0, 0, 0, 0, 0})}}};
    animate(builder, 0, "rotation", add_times(builder, {0}),
            builder.add<std::int16_t>("VEC4", i16, {0, 0, 23170, 23170}, true));
    animate(builder, 0, "weights", add_times(builder, {0}),
            builder.add<std::uint8_t>("SCALAR", u8, {51}, false)); // even if a file forgets to say so
    const Scene scene = Opened(builder).at(0.0);
    expect_near(glm::vec3(scene.instances[0].transform[0]), {0, 1, 0});
    expect_near(scene.meshes[0].positions[0], {2, 0, 0});
}

// Two nodes show one mesh with two targets, along z and x; the first node's weights are animated.
GltfBuilder morphing_triangles()
{
    GltfBuilder builder = triangle();
    json& mesh = builder.document["meshes"][0];
    mesh["primitives"][0]["targets"] = {{{"POSITION", builder.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1})}},
                                        {{"POSITION", builder.add_vec3({1, 0, 0, 1, 0, 0, 1, 0, 0})}}};
    mesh["weights"] = {0.0, 4.0};
    builder.add_node({{"mesh", 0}});
    builder.add_node({{"mesh", 0}});
    animate(builder, 0, "weights", add_times(builder, {0, 2}),
            builder.add<float>("SCALAR", f32, {1, 0, 3, 8}));
    return builder;
}

TEST(GltfAnimation, WeightsMoveOnlyTheNodeTheyAreOf)
{
    const Opened opened(morphing_triangles());
    const Scene scene = opened.at(1.0);
    ASSERT_EQ(scene.instances.size(), 3u);
    const auto first = [&](std::size_t i) {
        return scene.meshes.at(static_cast<std::size_t>(scene.instances[i].mesh)).positions[0];
    };
    expect_near(first(0), {4, 0, 2});
    expect_near(first(1), {4, 0, 0});
    EXPECT_EQ(scene.instances[1].mesh, scene.instances[2].mesh);
    Warnings warnings;
    const Scene rest = opened.file().scene(std::nullopt, warnings);
    expect_near(rest.meshes.at(static_cast<std::size_t>(rest.instances[0].mesh)).positions[0], {4, 0, 0});
    EXPECT_EQ(rest.meshes.size(), scene.meshes.size());
}

TEST(GltfAnimation, ABoneBentByAQuarterTurnTakesItsVerticesAlong)
{
    // Bones along y, the second from (0, 1, 0) on; vertices at its start, its end, and at its end by half.
    GltfBuilder builder;
    const int positions = builder.add_vec3({0, 1, 0, 0, 2, 0, 0.5f, 2, 0});
    const int joints = builder.add<std::uint8_t>("VEC4", u8, {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0});
    const int weights = builder.add_vec4({0, 1, 0, 0, 0, 1, 0, 0, 0.5f, 0.5f, 0, 0});
    builder.add_primitive(
        {{"attributes", {{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}}});
    builder.document["nodes"][0]["skin"] = 0;
    builder.add_node({{"children", {2}}});
    builder.document["nodes"].push_back({{"translation", {0, 1, 0}}});
    std::vector<float> bind(32, 0.0f);
    for (const std::size_t i : {0u, 5u, 10u, 15u})
        bind[i] = bind[16 + i] = 1.0f;
    bind[16 + 13] = -1.0f;
    builder.document["skins"] = {
        {{"joints", {1, 2}}, {"inverseBindMatrices", builder.add("MAT4", f32, bind)}}};
    animate(builder, 2, "rotation", add_times(builder, {0, 1}),
            builder.add_vec4({0, 0, 0, 1, 0, 0, root_half, root_half}));
    const Opened opened(builder);
    const std::vector<glm::vec3> rest = opened.at(0.0).meshes.at(0).positions,
                                 bent = opened.at(1.0).meshes.at(0).positions;
    expect_near(rest[2], {0.5f, 2, 0});
    expect_near(bent[0], {0, 1, 0});
    expect_near(bent[1], {-1, 1, 0});
    expect_near(bent[2], {-0.25f, 1.75f, 0}); // halfway from (0.5, 2, 0) to (-1, 1.5, 0)
}

TEST(GltfAnimation, CamerasAndLightsMoveToo)
{
    GltfBuilder builder = triangle();
    builder.document["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    builder.document["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    builder.add_node({{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    animate(builder, 1, "translation", add_times(builder, {0, 1}), builder.add_vec3({0, 0, 0, 0, 4, 0}));
    const Scene scene = Opened(builder).at(0.5);
    expect_near(glm::vec3(scene.cameras.at(0).transform[3]), {0, 2, 0});
    expect_near(scene.lights.at(0).position, {0, 2, 0});
}

TEST(GltfAnimation, AFlattenedInstanceKeepsItsPlaceOutOfSight)
{
    // Two nodes show one mesh; the first grows from nothing.
    GltfBuilder builder = triangle();
    builder.add_node({{"mesh", 0}, {"translation", {5, 0, 0}}});
    animate(builder, 0, "scale", add_times(builder, {0, 1}), builder.add_vec3({0, 0, 0, 2, 2, 2}));
    const Opened opened(builder);
    const Scene gone = opened.at(0.0), there = opened.at(1.0);
    ASSERT_EQ(gone.instances.size(), 2u);
    ASSERT_EQ(there.instances.size(), 2u);
    EXPECT_EQ(gone.meshes.size(), there.meshes.size());
    EXPECT_EQ(triangle_count(gone), 1u);
    EXPECT_EQ(triangle_count(there), 2u);
    EXPECT_EQ(gone.instances[0].transform, glm::mat4(1.0f));
    EXPECT_EQ(bounds(gone).low.x, 5.0f);
    expect_near(place(gone, 1), {5, 0, 0});
    EXPECT_EQ(bounds(there).low.x, 0.0f);
    Warnings warnings;
    EXPECT_EQ(opened.file().scene(Moment{0, 0.0}, warnings).instances.size(), 2u);
    EXPECT_TRUE(warned_once(warnings, "flattened"));
}

TEST(GltfAnimation, CamerasFrameTheSceneAtRest)
{
    const Opened opened(moving_triangle());
    const Scene scene = opened.at(3.0);
    EXPECT_EQ(bounds(scene).low.x, 3.0f);
    EXPECT_EQ(framed_bounds(scene).low.x, 0.0f);
    EXPECT_EQ(framed_bounds(scene).high.x, 1.0f);
    // Nothing to frame at rest: what is there is framed.
    GltfBuilder builder = moving_triangle();
    animate(builder, 0, "scale", add_times(builder, {0}), builder.add_vec3({1, 1, 1}));
    builder.document["nodes"][0]["scale"] = {0, 0, 0};
    EXPECT_EQ(framed_bounds(Opened(builder).at(3.0)).low.x, 3.0f);
}

TEST(GltfAnimation, APoseIsTheSceneWithoutItsImages)
{
    GltfBuilder builder = morphing_triangles();
    animate(builder, 1, "translation", add_times(builder, {0, 1}), builder.add_vec3({0, 0, 0, 0, 4, 0}));
    const Opened opened(builder);
    for (const double seconds : {0.3, 1.7, 0.3}) { // the second asks what the first kept
        Warnings warnings;
        const Scene whole = opened.file().scene(Moment{0, seconds}, warnings), posed = opened.at(seconds);
        ASSERT_EQ(whole.meshes.size(), posed.meshes.size());
        for (std::size_t i = 0; i < whole.meshes.size(); ++i) {
            EXPECT_EQ(whole.meshes[i].positions, posed.meshes[i].positions);
            EXPECT_EQ(whole.meshes[i].normals, posed.meshes[i].normals);
        }
        for (std::size_t i = 0; i < whole.instances.size(); ++i)
            EXPECT_EQ(whole.instances[i].transform, posed.instances[i].transform);
        EXPECT_EQ(whole.materials.size(), posed.materials.size());
        EXPECT_EQ(whole.rest_bounds->high, posed.rest_bounds->high);
    }
}

TEST(GltfAnimation, AnotherAnimationMovesOthers)
{
    GltfBuilder builder = moving_triangle();
    builder.add_node({{"mesh", 0}});
    json second = builder.document["animations"][0];
    second["channels"][0]["target"]["node"] = 1;
    builder.document["animations"].push_back(second);
    const Opened opened(builder);
    expect_near(place(opened.at(3.0, 1), 0), {0, 0, 0});
    expect_near(place(opened.at(3.0, 1), 1), {3, 0, 0});
    for (const int none : {-1, 2})
        EXPECT_THROW(opened.at(0.0, none), Error);
}

TEST(GltfAnimation, WhatIsNotKnownIsLeftOut)
{
    GltfBuilder builder = moving_triangle();
    json& document = builder.document;
    const json known = document["animations"][0]["channels"][0];
    const auto add_channel = [&](const json& target) {
        document["animations"][0]["channels"].push_back({{"sampler", 0}, {"target", target}});
    };
    builder.add_node({{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 7, 0, 0, 1}}});
    add_channel({{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", "/x"}}}}}});
    add_channel({{"node", 0}, {"path", "colour"}});
    add_channel({{"node", 1}, {"path", "translation"}});
    add_channel({{"node", 0}, {"path", "weights"}});
    document["animations"][0]["samplers"].push_back(
        {{"input", add_times(builder, {0})}, {"output", builder.add_vec3({9, 9, 9})}});
    document["animations"][0]["channels"].push_back({{"sampler", 1}, {"target", known["target"]}});
    const Opened opened(builder);
    EXPECT_EQ(
        opened.warnings,
        (Warnings{"test.gltf: 2 animation channels of unknown properties: left out",
                  "test.gltf: 1 animation channels of nodes with a matrix: left out",
                  "test.gltf: 1 animation channels of weights without morph targets: left out",
                  "test.gltf: 1 animation channels of properties that another channel animates: left out"}));
    expect_near(place(opened.at(3.0), 0), {3, 0, 0});
    expect_near(place(opened.at(3.0), 1), {7, 0, 0});
}

TEST(GltfAnimation, BrokenChannelsAreLeftOut)
{
    const auto broken = [](const std::function<void(GltfBuilder&, json&)>& damage) {
        GltfBuilder builder = moving_triangle();
        damage(builder, builder.document["animations"][0]);
        return complaint(builder);
    };
    const auto with_times = [&](const std::vector<float>& times) {
        return broken([&](GltfBuilder& b, json& a) { a["samplers"][0]["input"] = add_times(b, times); });
    };
    EXPECT_EQ(with_times({3, 1}), "test.gltf: animation 0, sampler 0: the time of key 1, 1 s, is before "
                                  "that of the key before: the channel is left out");
    EXPECT_EQ(with_times({0, std::nanf("")}), "test.gltf: animation 0, sampler 0: the time of key 1 is not "
                                              "within 1e+09 s: the channel is left out");
    EXPECT_EQ(with_times({0, infinite}), "test.gltf: animation 0, sampler 0: the time of key 1 is not within "
                                         "1e+09 s: the channel is left out");
    EXPECT_EQ(
        with_times({0, 1, 2}),
        "test.gltf: animation 0, sampler 0: 2 values for 3 keys, not 1 per key: the channel is left out");
    EXPECT_EQ(with_times({}), "test.gltf: animation 0, sampler 0: no keys: the channel is left out");
    EXPECT_EQ(
        broken([](GltfBuilder&, json& a) { a["samplers"][0]["interpolation"] = "CUBICSPLINE"; }),
        "test.gltf: animation 0, sampler 0: 2 values for 2 keys, not 3 per key: the channel is left out");
    EXPECT_EQ(
        broken([](GltfBuilder&, json& a) { a["samplers"][0]["interpolation"] = "EASE"; }),
        "test.gltf: animation 0, sampler 0: interpolation \"EASE\" is not defined by glTF: the channel is "
        "left out");
    EXPECT_EQ(
        broken([](GltfBuilder&, json& a) { a["samplers"][0]["output"] = 99; }),
        "test.gltf: animation 0, sampler 0, output: accessor 99 does not exist: the channel is left out");
    EXPECT_EQ(
        broken([](GltfBuilder&, json& a) { a["samplers"][0]["input"] = 99; }),
        "test.gltf: animation 0, sampler 0, input: accessor 99 does not exist: the channel is left out");
    EXPECT_EQ(broken([](GltfBuilder&, json& a) { a["samplers"][0].erase("input"); }),
              "test.gltf: animation 0, sampler 0: input is missing: left out");
    EXPECT_EQ(broken([](GltfBuilder&, json& a) { a["channels"][0]["sampler"] = 1; }),
              "test.gltf: animation 0, channel 0: sampler 1 does not exist: the channel is left out");
    EXPECT_EQ(broken([](GltfBuilder&, json& a) { a["channels"][0]["target"]["node"] = 1; }),
              "test.gltf: animation 0, channel 0: node 1 does not exist: the channel is left out");
    EXPECT_EQ(broken([](GltfBuilder&, json& a) { a["channels"][0].erase("target"); }),
              "test.gltf: animation 0, channel 0: target is missing: left out");
    EXPECT_EQ(broken([](GltfBuilder&, json& a) { a["channels"] = 3; }),
              "test.gltf: animation 0: channels is not an array: ignored");
}

TEST(GltfAnimation, TwoKeysAtOneTimeAreAJump)
{
    GltfBuilder builder = triangle();
    animate(builder, 0, "translation", add_times(builder, {0, 1, 1, 2}),
            builder.add_vec3({0, 0, 0, 1, 0, 0, 5, 0, 0, 6, 0, 0}));
    const Opened opened(builder);
    EXPECT_EQ(opened.warnings,
              Warnings{"test.gltf: animation 0, sampler 0: 1 keys have the time of the key before: "
                       "read as jumps"});
    expect_near(place(opened.at(0.5), 0), {0.5f, 0, 0});
    expect_near(place(opened.at(1.0), 0), {5, 0, 0});
    expect_near(place(opened.at(1.5), 0), {5.5f, 0, 0});
}

TEST(GltfAnimation, ChannelsOfBrokenValuesAreLeftOut)
{
    const auto with = [](const char* path, const std::function<int(GltfBuilder&)>& output) {
        GltfBuilder builder = triangle();
        const int input = add_times(builder, {0, 1}), values = output(builder);
        animate(builder, 0, path, input, values);
        return complaint(builder);
    };
    EXPECT_EQ(with("translation",
                   [](GltfBuilder& b) {
                       return b.add_vec3({0, 0, 0, 0, infinite, 0});
                   }),
              "test.gltf: animation 0, sampler 0: a value of key 1 is not finite: the channel is left out");
    EXPECT_EQ(
        with("rotation",
             [](GltfBuilder& b) {
                 return b.add_vec4({0, 0, 0, 1, 0, 0, 0, 0});
             }),
        "test.gltf: animation 0, sampler 0: the rotation of key 1 has no length: the channel is left out");
    EXPECT_EQ(with("rotation",
                   [](GltfBuilder& b) {
                       return b.add_vec3({0, 0, 0, 1, 0, 0});
                   }),
              "test.gltf: animation 0, sampler 0, output: accessor 2 is not VEC4: the channel is left out");
    EXPECT_EQ(with("scale",
                   [](GltfBuilder& b) {
                       return b.add<std::int8_t>("VEC3", i8, {1, 1, 1, 1, 1, 1}, true);
                   }),
              "test.gltf: animation 0, sampler 0, output: accessor 2 has componentType 5120, which is not "
              "allowed: the channel is left out");
    GltfBuilder builder = morphing_triangles();
    builder.document["animations"][0]["samplers"][0]["output"] = builder.add<float>("SCALAR", f32, {1, 0, 3});
    EXPECT_EQ(
        complaint(builder),
        "test.gltf: animation 0, sampler 0: 3 values for 2 keys, not 2 per key: the channel is left out");
    // Times that are no floats.
    builder = moving_triangle();
    builder.document["animations"][0]["samplers"][0]["input"] = builder.add_indices({0, 1});
    EXPECT_EQ(complaint(builder), "test.gltf: animation 0, sampler 0, input: accessor 3 has componentType "
                                  "5123, which is not allowed: the channel is left out");
}

TEST(GltfAnimation, MoreThanIsThereIsLeftOut)
{
    GltfBuilder builder = moving_triangle();
    for (const char* accessor : {"1", "2"}) {
        GltfBuilder cut = builder;
        cut.document["accessors"][std::stoul(accessor)]["count"] = 4294967295u;
        EXPECT_EQ(
            complaint(cut).find(std::string("test.gltf: accessor ") + accessor + ": 4294967295 elements"), 0u)
            << complaint(cut);
    }
    // A million zeros are no bytes: reading them again and again is work without an end.
    builder.document["accessors"].push_back({{"componentType", f32}, {"count", 300'000}, {"type", "VEC3"}});
    std::vector<float> times(300'000);
    for (std::size_t i = 0; i < times.size(); ++i)
        times[i] = static_cast<float>(i);
    json& animation = builder.document["animations"][0];
    animation["samplers"][0] = {{"input", add_times(builder, times)}, {"output", 3}};
    EXPECT_EQ(complaint(builder), "");
    for (int i = 1; i < 20; ++i) {
        builder.add_node({{"mesh", 0}});
        animation["channels"].push_back({{"sampler", 0}, {"target", {{"node", i}, {"path", "translation"}}}});
    }
    EXPECT_TRUE(contains(complaint(builder), "test.gltf: its animations read more than "))
        << complaint(builder);
}

TEST(GltfAnimation, AMomentOutOfBoundsIsRefusedThen)
{
    GltfBuilder builder = triangle();
    animate(builder, 0, "translation", add_times(builder, {0, 1}), builder.add_vec3({0, 0, 0, 3e38f, 0, 0}));
    const Opened opened(builder);
    EXPECT_EQ(opened.at(0.0).instances.size(), 1u);
    try {
        opened.at(1.0);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::bad_input);
        EXPECT_TRUE(contains(error.what(), "test.gltf: node 0: its vertices are more than")) << error.what();
    }
}

TEST(Curve, ACubicThatPassesThroughNothingKeepsARotation)
{
    Curve curve{{0, 1},
                {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0},
                4,
                Interpolation::cubic,
                true};
    EXPECT_EQ(value_at(curve, 0.5), (std::vector<double>{0, 0, 0, 1}));
}

} // namespace
} // namespace lambent::scene::test
