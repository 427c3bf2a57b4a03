// The outermost layer: GLB and JSON, told apart and checked.
#include "tests/scene/gltf_builder.h"

#include <gtest/gtest.h>

namespace lambent::scene::test {
namespace {

void set_u32(Bytes& bytes, std::size_t at, std::uint32_t value)
{
    for (std::size_t i = 0; i < 4; ++i)
        bytes[at + i] = static_cast<std::uint8_t>(value >> (8 * i));
}

TEST(GltfContainer, GlbAndGltfHoldTheSameScene)
{
    for (const Bytes& bytes : {triangle().glb(), triangle().gltf()}) {
        const Scene scene = load(bytes);
        ASSERT_EQ(scene.meshes.size(), 1u);
        ASSERT_EQ(scene.meshes[0].positions.size(), 3u);
        EXPECT_EQ(scene.meshes[0].positions[1], glm::vec3(1, 0, 0));
        EXPECT_EQ(scene.meshes[0].triangles[0], glm::uvec3(0, 1, 2));
    }
}

TEST(GltfContainer, JsonMayStartWithByteOrderMarkOrSpace)
{
    Bytes bytes = to_bytes("\xEF\xBB\xBF \n");
    const Bytes gltf = triangle().gltf();
    bytes.insert(bytes.end(), gltf.begin(), gltf.end());
    EXPECT_EQ(load(bytes).meshes.size(), 1u);
}

TEST(GltfContainer, UnknownChunksAfterTheBinaryOneArePassedOver)
{
    Bytes glb = triangle().glb();
    const Bytes chunk = {4, 0, 0, 0, 'X', 'T', 'R', 'A', 1, 2, 3, 4};
    glb.insert(glb.end(), chunk.begin(), chunk.end());
    set_u32(glb, 8, static_cast<std::uint32_t>(glb.size()));
    EXPECT_EQ(load(glb).meshes.size(), 1u);
}

TEST(GltfContainer, JsonChunkPaddedWithZerosIsRead)
{
    Bytes glb = make_glb(R"({"asset":{"version":"2.0"}} )", {});
    glb.back() = 0;
    EXPECT_TRUE(load(glb).meshes.empty());
}

TEST(GltfContainer, BadMagicIsNamed)
{
    Bytes glb = triangle().glb();
    glb[0] = 'G';
    EXPECT_EQ(refusal(glb), "test.gltf: neither glTF JSON nor GLB");
    EXPECT_EQ(refusal(Bytes{}), "test.gltf: neither glTF JSON nor GLB");
    EXPECT_EQ(refusal(to_bytes("  \n")), "test.gltf: neither glTF JSON nor GLB");
    EXPECT_EQ(refusal(to_bytes("[]")), "test.gltf: neither glTF JSON nor GLB");
}

TEST(GltfContainer, VersionAndLengthsAreChecked)
{
    Bytes version = triangle().glb();
    set_u32(version, 4, 1);
    EXPECT_EQ(refusal(version), "test.gltf: glTF 1.0 is not supported, only 2.0");

    Bytes longer = triangle().glb();
    set_u32(longer, 8, static_cast<std::uint32_t>(longer.size() + 1));
    EXPECT_TRUE(contains(refusal(longer), "GLB: the header declares"));

    Bytes shorter = triangle().glb();
    set_u32(shorter, 8, 11);
    EXPECT_TRUE(contains(refusal(shorter), "GLB: the header declares 11 bytes"));

    Bytes json_too_long = triangle().glb();
    set_u32(json_too_long, 12, 0xFFFFFFFF);
    EXPECT_TRUE(contains(refusal(json_too_long), "GLB: chunk at 12 declares 4294967295 bytes"));

    Bytes first_not_json = triangle().glb();
    set_u32(first_not_json, 16, 0x004E4942);
    EXPECT_EQ(refusal(first_not_json), "test.gltf: GLB: the first chunk is not JSON");
}

TEST(GltfContainer, EveryPrefixOfAFileIsRefused)
{
    for (const Bytes& whole : {triangle().glb(), triangle().gltf()}) {
        for (std::size_t length = 0; length < whole.size(); ++length)
            EXPECT_NE(refusal(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length))), "")
                << "the first " << length << " bytes";
    }
}

TEST(GltfJson, BrokenTextSaysWhere)
{
    EXPECT_TRUE(
        contains(refusal(to_bytes("{\"asset\": }")), "test.gltf: JSON: parse error at line 1, column 11"));
    EXPECT_TRUE(contains(refusal(to_bytes("{\"a\": \"\xC3(\"}")), "test.gltf: JSON:"));
}

// Brackets around what is not read cost neither stack nor memory, however many there are.
TEST(GltfJson, DeepNestingOfWhatIsNotReadIsNoFault)
{
    constexpr std::size_t depth = 1'000'000;
    const std::string deep = std::string(depth, '[') + std::string(depth, ']');
    const auto with = [](const std::string& member) {
        return to_bytes(R"({"asset":{"version":"2.0"},)" + member + "}");
    };
    EXPECT_EQ(refusal(with("\"extras\":" + deep)), "");
    EXPECT_EQ(refusal(with(R"("nodes":[{"extensions":{"VENDOR_x":{"y":)" + deep + "}}}]")), "");
    EXPECT_EQ(refusal(with("\"nodes\":" + deep)), "test.gltf: node 0: not an object");
    EXPECT_EQ(refusal(with("\"scene\":" + deep)),
              "test.gltf: scene is not a whole number from 0 to 2147483647");
    EXPECT_TRUE(contains(refusal(with("\"extras\":" + std::string(depth, '['))), "JSON: parse error"));
}

TEST(GltfJson, VersionsOtherThanTwoAreRefused)
{
    EXPECT_EQ(refusal(to_bytes("{}")), "test.gltf: asset is missing");
    EXPECT_EQ(refusal(to_bytes(R"({"asset":{}})")), "test.gltf: asset: version is missing");
    EXPECT_EQ(refusal(to_bytes(R"({"asset":{"version":"1.0"}})")),
              "test.gltf: glTF 1.0 is not supported, only 2.0");
    EXPECT_EQ(refusal(to_bytes(R"({"asset":{"version":"2.1","minVersion":"2.1"}})")),
              "test.gltf: requires glTF 2.1, only 2.0 is supported");
    EXPECT_EQ(refusal(to_bytes(R"({"asset":{"version":"2.1"}})")), "");
}

TEST(GltfJson, WhatIsOfAWrongTypeIsNamedByElementAndLeftOut)
{
    const auto with = [](const char* array, const json& element) {
        GltfBuilder builder = triangle();
        builder.document[array].push_back(element);
        return complaint(builder);
    };
    EXPECT_EQ(with("nodes", {{"mesh", -1}}),
              "test.gltf: node 1: mesh is not a whole number from 0 to 2147483647: ignored");
    EXPECT_EQ(with("nodes", {{"mesh", 4294967296}}),
              "test.gltf: node 1: mesh is not a whole number from 0 to 2147483647: ignored");
    EXPECT_EQ(with("nodes", {{"mesh", 0.5}}),
              "test.gltf: node 1: mesh is not a whole number from 0 to 2147483647: ignored");
    EXPECT_EQ(with("nodes", {{"mesh", "0"}}),
              "test.gltf: node 1: mesh is not a whole number from 0 to 2147483647: ignored");
    EXPECT_EQ(with("nodes", {{"children", {"x"}}}),
              "test.gltf: node 1: children is not a whole number from 0 to 2147483647: ignored");
    EXPECT_EQ(with("nodes", {{"matrix", {1, 2, 3}}}),
              "test.gltf: node 1: matrix has 3 numbers, not 16: ignored");
    EXPECT_EQ(with("nodes", {{"scale", {1, 1, 1e300}}}), "test.gltf: node 1: scale is too large: ignored");
    EXPECT_EQ(with("nodes", {{"scale", {1, 1, nullptr}}}),
              "test.gltf: node 1: scale is not a number: ignored");
    EXPECT_EQ(with("nodes", 7), "test.gltf: node 1: not an object: left out");
    EXPECT_EQ(with("accessors", {{"count", 1}, {"type", "VEC3"}}),
              "test.gltf: accessor 1: componentType is missing: left out");
    EXPECT_EQ(with("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", json::object()}}}}),
              "test.gltf: material 0, pbrMetallicRoughness, baseColorTexture: index is missing: ignored");
    EXPECT_EQ(with("materials", {{"doubleSided", 1}}),
              "test.gltf: material 0: doubleSided is not true or false: ignored");
    EXPECT_EQ(with("meshes", {{"primitives", {{{"attributes", {{"POSITION", "a"}}}}}}}),
              "test.gltf: mesh 1, primitive 0: POSITION is not a whole number from 0 to 2147483647: ignored");
    EXPECT_EQ(with("meshes", {{"primitives", 3}}), "test.gltf: mesh 1: primitives is not an array: ignored");
}

TEST(GltfJson, WholeNumbersMayBeWrittenAsFractions)
{
    GltfBuilder builder = triangle();
    builder.document["accessors"][0]["count"] = 3.0;
    builder.document["accessors"][0]["componentType"] = 5126.0;
    builder.document["nodes"][0]["mesh"] = 0.0;
    EXPECT_EQ(load(builder).meshes[0].positions.size(), 3u);
}

TEST(GltfJson, TheTopLevelMustBeAnObject)
{
    const Bytes glb = make_glb("[1, 2]", {});
    EXPECT_EQ(refusal(glb), "test.gltf: JSON: the top level is not an object");
    EXPECT_TRUE(contains(refusal(make_glb("{} {}", {})), "test.gltf: JSON: parse error"));
    EXPECT_TRUE(contains(refusal(make_glb("", Bytes(4))), "test.gltf: JSON: parse error"));
    EXPECT_TRUE(
        contains(refusal(to_bytes(R"({"asset":{"version":"2.0"},"scene":1e999})")), "number overflow"));
}

TEST(GltfJson, ExtrasOfAnyKindAreIgnored)
{
    GltfBuilder builder = triangle();
    builder.document["extras"] = {{"nodes", "not nodes"}, {"a", {1, 2, {{"extras", 3}}}}};
    builder.document["nodes"][0]["extras"] = 5;
    builder.document["meshes"][0]["primitives"][0]["extras"] = {{"indices", -3}};
    EXPECT_EQ(load(builder).meshes.size(), 1u);
}

TEST(GltfExtensions, RequiredOnesThatAreNotSupportedAreAllNamed)
{
    GltfBuilder builder = triangle();
    builder.document["extensionsRequired"] = {"EXT_meshopt_compression", "KHR_mesh_quantization",
                                              "VENDOR_\nodd"};
    EXPECT_EQ(refusal(builder),
              "test.gltf: requires extensions that are not supported: EXT_meshopt_compression, VENDOR_?odd");
}

TEST(GltfExtensions, UsedOnesThatAreNotSupportedAreWarnedOfOnce)
{
    GltfBuilder builder = triangle();
    builder.document["extensionsUsed"] = {"KHR_materials_unlit", "KHR_materials_iridescence", "VENDOR_x"};
    Warnings warnings;
    load(builder, &warnings);
    EXPECT_EQ(warnings, Warnings{"test.gltf: extensions ignored: KHR_materials_iridescence, VENDOR_x"});
}

TEST(GltfBuffers, ABufferShorterThanItSaysIsUsedAsFarAsItGoes)
{
    GltfBuilder builder = triangle();
    builder.document["buffers"] = {{{"byteLength", 40}}};
    EXPECT_EQ(complaint(builder.glb()),
              "test.gltf: buffer 0: 40 bytes declared, only 36 present: these are used");
    builder.document["buffers"] = {{{"byteLength", 36}, {"uri", "data:;base64,AAAA"}}};
    EXPECT_EQ(refusal(builder.gltf()), "test.gltf: buffer 0: 36 bytes declared, only 3 present");
}

TEST(GltfBuffers, ABufferWithoutBytesIsRefusedWhereItIsUsed)
{
    GltfBuilder builder = triangle();
    builder.document["buffers"] = {{{"byteLength", 36}}};
    EXPECT_EQ(refusal(builder.gltf()), "test.gltf: bufferView 0: buffer 0 has no bytes");
    builder.document["bufferViews"][0]["buffer"] = 7;
    EXPECT_EQ(refusal(builder.gltf()), "test.gltf: bufferView 0: buffer 7 does not exist");
    // Not used: no harm.
    builder = triangle();
    builder.document["buffers"] = {{{"byteLength", 36}}, {{"byteLength", 1000}}};
    EXPECT_EQ(refusal(builder.glb()), "");
}

TEST(GltfBuffers, ALongerBinaryChunkThanTheBufferIsFine)
{
    GltfBuilder builder = triangle();
    builder.document["buffers"] = {{{"byteLength", 36}}};
    builder.binary.resize(40);
    EXPECT_EQ(load(builder.glb()).meshes.size(), 1u);
}

} // namespace
} // namespace lambent::scene::test
