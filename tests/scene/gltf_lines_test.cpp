// Points and lines: what the seven modes make, their materials, and what is done to them as to triangles.
#include "scene/gltf/gltf.h"
#include "tests/scene/gltf_builder.h"

#include <gtest/gtest.h>

#include <limits>

namespace lambent::scene::test {
namespace {

using Lines = std::vector<glm::uvec2>;
using Points = std::vector<std::uint32_t>;

// Five vertices, drawn by node 0.
GltfBuilder five_vertices(int mode, const json& more_attributes = json::object())
{
    GltfBuilder builder;
    json attributes = {{"POSITION", builder.add_vec3({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 7})}};
    attributes.update(more_attributes);
    builder.add_primitive({{"attributes", attributes}, {"mode", mode}});
    return builder;
}

// {v_i}, {v_2i, v_2i+1}, {v_i, v_(i+1) mod n}, {v_i, v_i+1} [glTF 2.0, 3.7.2.1]
TEST(GltfLines, ModesAreAsSpecified)
{
    Warnings warnings;
    EXPECT_EQ(load(five_vertices(0), &warnings).meshes.at(0).points, (Points{0, 1, 2, 3, 4}));
    EXPECT_EQ(load(five_vertices(2), &warnings).meshes.at(0).lines,
              (Lines{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}}));
    EXPECT_EQ(load(five_vertices(3), &warnings).meshes.at(0).lines, (Lines{{0, 1}, {1, 2}, {2, 3}, {3, 4}}));
    EXPECT_EQ(warnings, Warnings());
    const Scene scene = load(five_vertices(1), &warnings);
    EXPECT_EQ(scene.meshes.at(0).lines, (Lines{{0, 1}, {2, 3}}));
    EXPECT_TRUE(scene.meshes.at(0).triangles.empty());
    EXPECT_TRUE(warned_once(warnings, "1 indices after the last whole triangle or line left out"));
}

TEST(GltfLines, IndicesMayRepeatTurnBackAndLeaveVerticesOut)
{
    GltfBuilder builder = five_vertices(2);
    json& primitive = builder.document["meshes"][0]["primitives"][0];
    primitive["indices"] = builder.add_indices({4, 1, 1, 2});
    EXPECT_EQ(load(builder).meshes.at(0).lines, (Lines{{4, 1}, {1, 2}, {2, 4}}));
    primitive["indices"] = builder.add_indices({4, 1});
    const Scene there_and_back = load(builder);
    EXPECT_EQ(there_and_back.meshes.at(0).positions, (std::vector<glm::vec3>{{1, 0, 0}, {0, 0, 7}}));
    EXPECT_EQ(there_and_back.meshes.at(0).lines, (Lines{{1, 0}}));
    primitive["mode"] = 0;
    primitive["indices"] = builder.add_indices({3, 3, 1});
    EXPECT_EQ(load(builder).meshes.at(0).points, (Points{1, 1, 0}));
    primitive["indices"] = builder.add_indices({5});
    EXPECT_TRUE(contains(refusal(builder), "index 5 is past its 5 vertices"));
}

// 65535 is no vertex: lists and strips end there, a loop closes, and of points it is none. [OpenGL 4.6, 10.3.6]
TEST(GltfLines, RestartsEndThem)
{
    const auto with = [](int mode) {
        GltfBuilder builder = five_vertices(mode);
        builder.document["meshes"][0]["primitives"][0]["indices"] =
            builder.add_indices({0, 1, 2, 65535, 65535, 3, 4, 0});
        return builder;
    };
    EXPECT_EQ(load(with(0)).meshes.at(0).points, (Points{0, 1, 2, 3, 4, 0}));
    EXPECT_EQ(load(with(1)).meshes.at(0).positions.size(), 4u) << "vertex 2 has no partner, nor the last one";
    EXPECT_EQ(load(with(1)).meshes.at(0).lines, (Lines{{0, 1}, {2, 3}}));
    EXPECT_EQ(load(with(2)).meshes.at(0).lines, (Lines{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 0}, {0, 3}}));
    EXPECT_EQ(load(with(3)).meshes.at(0).lines, (Lines{{0, 1}, {1, 2}, {3, 4}, {4, 0}}));
    for (const int mode : {0, 1, 2, 3})
        EXPECT_EQ(complaint(with(mode)),
                  "test.gltf: 2 indices are the largest of their type, which restarts the primitive: "
                  "triangles and lines end there");
}

TEST(GltfLines, BrokenPositionsCostWhatTouchesThem)
{
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const auto with = [](int mode, std::vector<std::uint16_t> indices) {
        GltfBuilder builder;
        const int positions = builder.add_vec3({0, nan, 0, 1, 0, 0, 2, 0, 0});
        builder.add_primitive({{"attributes", {{"POSITION", positions}}}, {"mode", mode}});
        builder.document["meshes"][0]["primitives"][0]["indices"] = builder.add_indices(indices);
        return builder;
    };
    EXPECT_EQ(load(with(3, {0, 1, 2})).meshes.at(0).lines, (Lines{{1, 2}}));
    EXPECT_EQ(load(with(0, {2, 0, 1})).meshes.at(0).points, (Points{2, 1}));
    EXPECT_EQ(bounds(load(with(0, {2, 0, 1}))).low, glm::vec3(1, 0, 0));
    EXPECT_EQ(complaint(with(0, {2, 0, 1})),
              "test.gltf: 1 triangles, lines or points with positions that are not finite left out");
    EXPECT_EQ(refusal(with(3, {0, 1})),
              "test.gltf: mesh 0, primitive 0: the position of vertex 0 is not finite");
}

// Nothing but lines is something to draw, whatever else is lost.
TEST(GltfLines, BrokenPartsCostThemselves)
{
    GltfBuilder builder = five_vertices(3);
    json& primitives = builder.document["meshes"][0]["primitives"];
    primitives[0]["attributes"]["NORMAL"] = builder.add_vec2({0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 0}});
    primitives[1]["indices"] = builder.add_indices({9});
    Warnings warnings;
    const Scene scene = load(builder, &warnings);
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_TRUE(scene.materials.at(static_cast<std::size_t>(scene.meshes[0].material)).unlit);
    EXPECT_TRUE(warned_once(warnings, "mesh 0, primitive 0, NORMAL: accessor 1 is not VEC3: left out"));
    EXPECT_TRUE(
        warned_once(warnings, "primitive 1: index 9 is past its 5 vertices: the primitive is left out"));
    EXPECT_EQ(warnings.size(), 2u);
}

// A joint takes them beyond what floats hold: there, the mesh is empty, and the materials are the same ones.
TEST(GltfLines, EveryMomentHasTheSameMeshesAndMaterials)
{
    GltfBuilder builder = triangle();
    const int joints = builder.add<std::uint8_t>("VEC4", u8, std::vector<std::uint8_t>(8, 0)),
              weights = builder.add_vec4({1, 0, 0, 0, 1, 0, 0, 0}),
              positions = builder.add_vec3({1, 0, 0, 2, 0, 0});
    builder.add_primitive(
        {{"attributes", {{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}},
         {"mode", 1}});
    builder.document["nodes"].back()["skin"] = 0;
    const int joint = builder.add_node({{"scale", {1, 1, 1}}});
    builder.document["skins"] = json::array({{{"joints", {joint}}}});
    const int times = builder.add("SCALAR", f32, std::vector<float>{0, 1}),
              places = builder.add_vec3({0, 0, 0, 3e38f, 0, 0}),
              sizes = builder.add_vec3({1, 1, 1, 3e38f, 3e38f, 3e38f});
    const auto channel = [&](int sampler, const char* path) {
        return json{{"sampler", sampler}, {"target", {{"node", joint}, {"path", path}}}};
    };
    builder.document["animations"] = json::array(
        {{{"channels", {channel(0, "translation"), channel(1, "scale")}},
          {"samplers", {{{"input", times}, {"output", places}}, {{"input", times}, {"output", sizes}}}}}});
    const Bytes bytes = builder.glb();
    Warnings warnings;
    const GltfFile file({"test.gltf", bytes, std::nullopt, {}}, warnings);
    const Scene rest = file.scene(std::nullopt, warnings), away = file.pose({0, 1.0});
    EXPECT_TRUE(has_lines(rest));
    EXPECT_FALSE(has_lines(away));
    ASSERT_EQ(away.meshes.size(), rest.meshes.size());
    EXPECT_EQ(away.materials.size(), rest.materials.size());
    for (std::size_t i = 0; i < rest.meshes.size(); ++i)
        EXPECT_EQ(away.meshes[i].material, rest.meshes[i].material);
    EXPECT_EQ(away.instances.size(), rest.instances.size());
}

TEST(GltfLines, AreCountedAndBounded)
{
    GltfBuilder builder = five_vertices(3);
    builder.add_node({{"mesh", 0}, {"translation", {10, 0, 0}}});
    builder.add_primitive(
        {{"attributes", {{"POSITION", builder.add_vec3({-1, 0, 0, -2, -3, 0})}}}, {"mode", 0}});
    const Scene scene = load(builder);
    EXPECT_TRUE(has_lines(scene));
    EXPECT_EQ(line_count(scene).lines, 8u);
    EXPECT_EQ(line_count(scene).points, 2u);
    EXPECT_EQ(triangle_count(scene), 20u);
    EXPECT_EQ(bounds(scene).low, glm::vec3(-2, -3, 0));
    EXPECT_EQ(bounds(scene).high, glm::vec3(11, 1, 7));
}

// "For POINTS or LINES with no NORMAL property, don't calculate lighting"; "with no TANGENT property, render with standard
// lighting but ignore any normal maps". [glTF 2.0, 3.9.6]
TEST(GltfLines, AreLitWhereTheyHaveNormals)
{
    GltfBuilder builder = triangle();
    builder.document["materials"] = json::array({{{"pbrMetallicRoughness", {{"metallicFactor", 0.25}}}}});
    builder.document["meshes"][0]["primitives"][0]["material"] = 0;
    const int positions = builder.add_vec3({0, 0, 0, 1, 0, 0});
    builder.add_primitive({{"attributes", {{"POSITION", positions}}}, {"mode", 1}, {"material", 0}});
    builder.add_primitive({{"attributes", {{"POSITION", positions}}}, {"mode", 0}, {"material", 0}});
    const int normals = builder.add_vec3({0, 0, 2, 0, 1, 0}), uvs = builder.add_vec2({0, 0, 1, 0});
    builder.add_primitive(
        {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uvs}}},
         {"mode", 3},
         {"material", 0}});
    const Scene scene = load(builder);
    ASSERT_EQ(scene.meshes.size(), 4u);
    const auto material = [&](std::size_t mesh) {
        return scene.materials.at(static_cast<std::size_t>(scene.meshes[mesh].material));
    };
    for (std::size_t mesh = 0; mesh < 4; ++mesh) {
        EXPECT_EQ(material(mesh).metallic, 0.25f);
        EXPECT_EQ(material(mesh).unlit, mesh == 1 || mesh == 2);
        EXPECT_EQ(material(mesh).double_sided, mesh != 0);
    }
    EXPECT_EQ(scene.meshes[1].material, scene.meshes[2].material);
    EXPECT_TRUE(scene.meshes[1].normals.empty());
    EXPECT_EQ(scene.meshes[3].normals, (std::vector<glm::vec3>{{0, 0, 1}, {0, 1, 0}}));
    EXPECT_TRUE(scene.meshes[3].tangents.empty());
    EXPECT_EQ(scene.meshes[3].texcoords[0][1], glm::vec2(1, 0));
}

TEST(GltfLines, AreMorphedAndSkinned)
{
    GltfBuilder builder;
    const int positions = builder.add_vec3({0, 0, 0, 1, 0, 0}), moved = builder.add_vec3({0, 4, 0, 0, 0, 8});
    const int joints = builder.add<std::uint8_t>("VEC4", u8, {0, 0, 0, 0, 1, 0, 0, 0}),
              weights = builder.add_vec4({1, 0, 0, 0, 1, 0, 0, 0});
    builder.add_primitive(
        {{"attributes", {{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}},
         {"targets", json::array({{{"POSITION", moved}}})},
         {"mode", 1}});
    builder.document["meshes"][0]["weights"] = {0.5};
    builder.document["nodes"][0]["skin"] = 0;
    const int still = builder.add_node({{"translation", {0, 0, 0}}}),
              high = builder.add_node({{"translation", {0, 100, 0}}});
    builder.document["skins"] = json::array({{{"joints", {still, high}}}});
    EXPECT_EQ(load(builder).meshes.at(0).positions, (std::vector<glm::vec3>{{0, 2, 0}, {1, 100, 4}}));
}

// A million points that take no bytes, shown six times: the first is free, four million more are drawn.
TEST(GltfLines, AreNotRepeatedWithoutEnd)
{
    GltfBuilder builder;
    builder.document["accessors"] =
        json::array({{{"componentType", f32}, {"type", "VEC3"}, {"count", 1'000'000}}});
    builder.add_primitive({{"attributes", {{"POSITION", 0}}}, {"mode", 0}});
    for (int i = 0; i < 5; ++i)
        builder.add_node({{"mesh", 0}});
    Warnings warnings;
    const Scene scene = load(builder, &warnings);
    EXPECT_EQ(scene.instances.size(), 5u);
    EXPECT_TRUE(warned_once(warnings, "1 instances of points and lines beyond the limit of 4000000"));
}

} // namespace
} // namespace lambent::scene::test
