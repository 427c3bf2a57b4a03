// What a broken part costs: that part, one line for each kind of fault, and never a change of what is numbered.
#include "scene/gltf/gltf.h"
#include "scene/gltf_document/gltf_losses.h"
#include "tests/scene/gltf_builder.h"
#include "tests/scene/png_writer.h"

#include <gtest/gtest.h>

namespace lambent::scene::test {
namespace {

TEST(Losses, FaultsThatDifferInNumbersBecomeOneLine)
{
    Warnings warnings = {"before"};
    Losses losses("a.gltf", warnings);
    losses.add("a.gltf: node 3: lost", "left out");
    losses.add("a.gltf: light 1: dark");
    for (int i = 0; i < 41; ++i)
        losses.add("a.gltf: node " + std::to_string(i * i) + ": lost", "left out");
    losses.add("", "left out");
    EXPECT_EQ(warnings, (Warnings{"before", "a.gltf: node 3: lost: left out (and 41 more like it)",
                                  "a.gltf: light 1: dark"}));
}

TEST(Losses, OfManyKindsTheRestIsCounted)
{
    Warnings warnings;
    Losses losses("a.gltf", warnings);
    for (std::size_t i = 0; i < Losses::most_lines + 1000; ++i)
        losses.add("a.gltf: " + std::string(i, 'x'));
    EXPECT_EQ(warnings.size(), Losses::most_lines + 1);
    EXPECT_EQ(warnings.back(), "a.gltf: and 1000 more faults");
}

TEST(Losses, OtherFailuresPass)
{
    Warnings warnings;
    Losses losses("a.gltf", warnings);
    EXPECT_TRUE(losses.spare("left out", [] {}));
    EXPECT_FALSE(losses.spare("left out", [] { throw Error(Failure::bad_input, "broken"); }));
    EXPECT_EQ(warnings, Warnings{"broken: left out"});
    EXPECT_THROW(losses.spare("left out", [] { throw Error(Failure::usage, "wrong"); }), Error);
}

// A triangle that draws, and beside it others that do not.
GltfBuilder with_broken_primitives(int count)
{
    GltfBuilder builder = triangle();
    json& primitives = builder.document["meshes"][0]["primitives"];
    const int indices = builder.add_indices({0, 1, 7});
    for (int i = 0; i < count; ++i)
        primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"indices", indices}});
    return builder;
}

TEST(GltfLosses, ABrokenPrimitiveCostsItself)
{
    const GltfBuilder builder = with_broken_primitives(3);
    EXPECT_EQ(load(builder).instances.size(), 1u);
    EXPECT_EQ(complaint(builder), "test.gltf: mesh 0, primitive 1: index 7 is past its 3 vertices: "
                                  "the primitive is left out (and 2 more like it)");
}

TEST(GltfLosses, WithNothingLeftTheFaultIsTheError)
{
    GltfBuilder builder = with_broken_primitives(2);
    builder.document["meshes"][0]["primitives"].erase(0);
    EXPECT_EQ(refusal(builder), "test.gltf: mesh 0, primitive 0: index 7 is past its 3 vertices");
    // Nothing to draw, but nothing broken of it.
    GltfBuilder empty;
    empty.document["materials"] = {{{"doubleSided", 3}}};
    EXPECT_EQ(refusal(empty), "");
}

TEST(GltfLosses, AMissingBufferCostsWhatIsInIt)
{
    GltfBuilder builder = triangle();
    builder.document["buffers"] = {{{"byteLength", builder.binary.size()}},
                                   {{"byteLength", 36}, {"uri", "gone.bin"}}};
    builder.document["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 36}});
    const int gone = builder.add_to(
        "accessors", {{"bufferView", 1}, {"componentType", f32}, {"count", 3}, {"type", "VEC3"}});
    builder.document["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", gone}}}});
    Warnings warnings;
    EXPECT_EQ(load(builder.glb(), &warnings).instances.size(), 1u);
    EXPECT_EQ(
        warnings,
        (Warnings{
            "test.gltf: buffer 1: \"gone.bin\" is an external file; only embedded data is read: left out",
            "test.gltf: bufferView 1: buffer 1 has no bytes: the primitive is left out"}));
    builder.document["meshes"][0]["primitives"].erase(0);
    EXPECT_EQ(refusal(builder.glb()),
              "test.gltf: buffer 1: \"gone.bin\" is an external file; only embedded data is read");
}

TEST(GltfLosses, ABrokenAttributeIsMadeAnewOrLeftOut)
{
    GltfBuilder builder = triangle();
    json& attributes = builder.document["meshes"][0]["primitives"][0]["attributes"];
    attributes["NORMAL"] = builder.add_vec2({0, 0, 0, 0, 0, 0});
    const Mesh flat = load(builder).meshes.at(0);
    EXPECT_EQ(flat.normals, std::vector<glm::vec3>(3, glm::vec3(0, 0, 1)));
    EXPECT_EQ(complaint(builder), "test.gltf: mesh 0, primitive 0, NORMAL: accessor 1 is not VEC3: left out");
    attributes = {{"POSITION", 0}, {"COLOR_0", 77}};
    EXPECT_TRUE(load(builder).meshes.at(0).colors.empty());
    EXPECT_EQ(complaint(builder),
              "test.gltf: mesh 0, primitive 0, COLOR_0: accessor 77 does not exist: left out");
    attributes = {{"POSITION", 0}, {"TEXCOORD_0", "a"}};
    EXPECT_TRUE(load(builder).meshes.at(0).texcoords[0].empty());
    EXPECT_EQ(complaint(builder),
              "test.gltf: mesh 0, primitive 0: TEXCOORD_0 is not a whole number from 0 to "
              "2147483647: ignored");
}

// A set that the material asks for costs itself like the first two; one that nothing reads may be of any kind.
TEST(GltfLosses, AnySetOfTextureCoordinatesCostsItself)
{
    GltfBuilder builder = triangle();
    builder.add_to("images", {{"bufferView", builder.add_view(make_png({1, 1, 8, {1, 2, 3, 4}}))}});
    builder.add_to("textures", {{"source", 0}});
    builder.add_to("materials", {{"emissiveTexture", {{"index", 0}, {"texCoord", 6}}}});
    json& primitive = builder.document["meshes"][0]["primitives"][0];
    primitive["material"] = 0;
    primitive["attributes"]["TEXCOORD_5"] = 0;
    primitive["attributes"]["TEXCOORD_6"] = 0;
    Warnings warnings;
    const Scene scene = load(builder, &warnings);
    EXPECT_TRUE(scene.meshes.at(0).texcoords[6].empty());
    EXPECT_EQ(warnings,
              (Warnings{"test.gltf: mesh 0, primitive 0, TEXCOORD_6: accessor 0 is not VEC2: left out",
                        "test.gltf: 1 primitives have textures but not their texture coordinates: "
                        "(0, 0) is used"}));
}

TEST(GltfLosses, WhatStandsForABrokenElementIsNotComplainedOfAgain)
{
    GltfBuilder builder = triangle();
    builder.document["accessors"].push_back({{"count", 3}, {"type", "VEC3"}, {"componentType", 5124}});
    builder.document["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 1}}}});
    builder.document["meshes"][0]["primitives"].push_back(5);
    builder.document["skins"] = {7};
    builder.document["nodes"][0]["skin"] = 0;
    builder.document["cameras"] = {7};
    builder.document["nodes"][0]["camera"] = 0;
    Warnings warnings;
    EXPECT_EQ(load(builder, &warnings).instances.size(), 1u);
    EXPECT_EQ(warnings,
              (Warnings{"test.gltf: accessor 1: componentType 5124 is not defined by glTF: left out",
                        "test.gltf: camera 0: not an object: left out",
                        "test.gltf: mesh 0, primitive 2: not an object: left out",
                        "test.gltf: skin 0: not an object: left out"}));
}

TEST(GltfLosses, AChannelAfterABrokenOneKeepsItsNumber)
{
    GltfBuilder builder = triangle();
    builder.document["animations"] = {
        {{"channels", {7, {{"sampler", 9}, {"target", {{"node", 0}, {"path", "scale"}}}}}}}};
    Warnings warnings;
    load(builder, &warnings);
    EXPECT_EQ(
        warnings,
        (Warnings{"test.gltf: animation 0, channel 0: not an object: left out",
                  "test.gltf: animation 0, channel 1: sampler 9 does not exist: the channel is left out"}));
}

// Two triangles, of which the second follows a joint that an animation lets fly away; and a texture that is none.
GltfBuilder flying_away()
{
    GltfBuilder b = with_broken_primitives(1);
    json& primitives = b.document["meshes"][0]["primitives"];
    primitives[0]["material"] = 0;
    primitives[0]["attributes"]["TEXCOORD_0"] = b.add_vec2({0, 0, 1, 0, 0, 1});
    b.document["materials"] = {{{"emissiveTexture", {{"index", 1}}}, {"normalTexture", {{"index", 0}}}}};
    b.add_to("images", {{"bufferView", b.add_view(to_bytes("no picture"))}});
    b.add_to("images", {{"bufferView", b.add_view(make_png({1, 1, 8, {1, 2, 3, 4}}))}});
    b.document["textures"] = {{{"source", 0}}, {{"source", 1}}};
    const int joints = b.add<std::uint8_t>("VEC4", u8, std::vector<std::uint8_t>(12, 0));
    const int weights = b.add_vec4({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    const int skinned =
        b.add_primitive({{"attributes", {{"POSITION", 0}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}}});
    b.document["nodes"].back()["skin"] = 0;
    b.add_node({{"scale", {1, 1, 1}}});
    b.document["skins"] = {{{"joints", {2}}}};
    EXPECT_EQ(skinned, 1);
    const int times = b.add("SCALAR", f32, std::vector<float>{0, 1});
    const int places = b.add_vec3({0, 0, 0, 3e38f, 0, 0});
    const int sizes = b.add_vec3({1, 1, 1, 3e38f, 3e38f, 3e38f});
    b.document["animations"] = {
        {{"channels",
          {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "translation"}}}},
           {{"sampler", 1}, {"target", {{"node", 2}, {"path", "scale"}}}}}},
         {"samplers", {{{"input", times}, {"output", places}}, {{"input", times}, {"output", sizes}}}}}};
    return b;
}

TEST(GltfLosses, EveryMomentHasTheSameMeshesInstancesAndImages)
{
    const Bytes bytes = flying_away().glb();
    for (const bool scene_first : {true, false}) {
        Warnings warnings;
        const GltfFile file({"test.gltf", bytes, std::nullopt, {}}, warnings);
        if (scene_first)
            file.scene(std::nullopt, warnings);
        const Scene away = file.pose({0, 1.0});
        const Scene rest = file.scene(std::nullopt, warnings);
        EXPECT_EQ(triangle_count(rest), 2u);
        EXPECT_EQ(triangle_count(away), 1u) << "the one that flew away is left out";
        EXPECT_EQ(rest.instances.size(), 3u);
        EXPECT_EQ(away.instances.size(), rest.instances.size());
        EXPECT_EQ(away.meshes.size(), rest.meshes.size());
        for (const Scene* scene : {&rest, &away}) {
            EXPECT_EQ(scene->materials.at(0).emissive_texture.image, 0);
            EXPECT_EQ(scene->materials.at(0).normal_texture.image, -1);
        }
        EXPECT_EQ(rest.images.size(), 1u);
    }
}

} // namespace
} // namespace lambent::scene::test
