// Primitives: modes, indices, attributes, and the vertices that the loader has to complete.
#include "tests/scene/gltf_builder.h"
#include "tests/scene/png_writer.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace lambent::scene::test {
namespace {

// Five points, no three in a line, at z = 0; with normals, so that vertices stay as they are.
GltfBuilder five_points(int mode, const std::function<int(GltfBuilder&)>& add_indices = {})
{
    GltfBuilder builder;
    const int positions = builder.add_vec3({0, 0, 0, 0, -1, 0, 1, 0, 0, 1, -1, 0, 2, 0, 0});
    const int normals = builder.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    json primitive = {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}, {"mode", mode}};
    if (add_indices)
        primitive["indices"] = add_indices(builder);
    builder.add_primitive(primitive);
    return builder;
}

using Triangles = std::vector<glm::uvec3>;

TEST(GltfMesh, StripsAndFansUnfoldAsSpecified)
{
    // p_i = {v_i, v_(i + 1 + i % 2), v_(i + 2 - i % 2)} and {v_(i + 1), v_(i + 2), v_0} [glTF 2.0, 3.7.2.1]
    EXPECT_EQ(load(five_points(5)).meshes.at(0).triangles, (Triangles{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}));
    EXPECT_EQ(load(five_points(6)).meshes.at(0).triangles, (Triangles{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}}));
    EXPECT_EQ(load(five_points(4)).meshes.at(0).triangles, (Triangles{{0, 1, 2}}));
}

TEST(GltfMesh, AllKindsOfIndicesAreRead)
{
    const Triangles expected = {{4, 3, 2}, {0, 1, 2}};
    EXPECT_EQ(load(five_points(4,
                               [](GltfBuilder& b) {
                                   return b.add<std::uint8_t>("SCALAR", u8, {4, 3, 2, 0, 1, 2});
                               }))
                  .meshes.at(0)
                  .triangles,
              expected);
    EXPECT_EQ(load(five_points(4,
                               [](GltfBuilder& b) {
                                   return b.add<std::uint16_t>("SCALAR", u16, {4, 3, 2, 0, 1, 2});
                               }))
                  .meshes.at(0)
                  .triangles,
              expected);
    EXPECT_EQ(load(five_points(4,
                               [](GltfBuilder& b) {
                                   return b.add<std::uint32_t>("SCALAR", u32, {4, 3, 2, 0, 1, 2});
                               }))
                  .meshes.at(0)
                  .triangles,
              expected);
}

TEST(GltfMesh, StitchesInStripsAreLeftOut)
{
    const auto stitched = five_points(5, [](GltfBuilder& b) {
        return b.add_indices({0, 1, 2, 2, 1, 1, 3, 2});
    });
    // Of the six triangles the first and the last have three corners: {v0, v1, v2} and {v5, v7, v6}.
    EXPECT_EQ(load(stitched).meshes.at(0).triangles, (Triangles{{0, 1, 2}, {1, 2, 3}}));
}

TEST(GltfMesh, IndicesMustStayBelowTheVertices)
{
    EXPECT_EQ(refusal(five_points(4,
                                  [](GltfBuilder& b) {
                                      return b.add_indices({0, 1, 5});
                                  })),
              "test.gltf: mesh 0, primitive 0: index 5 is past its 5 vertices");
    EXPECT_EQ(
        refusal(five_points(4,
                            [](GltfBuilder& b) {
                                return b.add<float>("SCALAR", f32, {0, 1, 2});
                            })),
        "test.gltf: mesh 0, primitive 0, indices: accessor 2 has componentType 5126, which is not allowed");
    EXPECT_EQ(
        refusal(five_points(4,
                            [](GltfBuilder& b) {
                                return b.add<std::int8_t>("SCALAR", i8, {0, 1, 2});
                            })),
        "test.gltf: mesh 0, primitive 0, indices: accessor 2 has componentType 5120, which is not allowed");
    GltfBuilder missing = five_points(4);
    missing.document["meshes"][0]["primitives"][0]["indices"] = 12;
    EXPECT_NE(refusal(missing), "");
}

TEST(GltfMesh, IndicesAfterTheLastTriangleAreWarnedOf)
{
    Warnings warnings;
    const Scene scene = load(five_points(4,
                                         [](GltfBuilder& b) {
                                             return b.add_indices({0, 1, 2, 3});
                                         }),
                             &warnings);
    EXPECT_EQ(scene.meshes.at(0).triangles.size(), 1u);
    EXPECT_EQ(warnings, Warnings{"test.gltf: 1 indices after the last whole triangle or line left out"});
}

TEST(GltfMesh, AnUnknownModeCostsThePrimitive)
{
    EXPECT_EQ(refusal(five_points(7)), "test.gltf: mesh 0, primitive 0: mode 7 is not defined by glTF");
    GltfBuilder builder = five_points(7);
    json& primitives = builder.document["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
    primitives.back()["mode"] = 4;
    Warnings warnings;
    EXPECT_EQ(load(builder, &warnings).meshes.size(), 1u);
    EXPECT_TRUE(warned_once(
        warnings,
        "test.gltf: mesh 0, primitive 0: mode 7 is not defined by glTF: the primitive is left out"));
}

TEST(GltfMesh, APrimitiveWithoutPositionsIsLeftOut)
{
    GltfBuilder builder = triangle();
    builder.document["meshes"][0]["primitives"][0]["attributes"] = {{"NORMAL", 0}};
    Warnings warnings;
    EXPECT_TRUE(load(builder, &warnings).instances.empty());
    EXPECT_TRUE(warned_once(warnings, "without positions"));
    EXPECT_TRUE(warned_once(warnings, "nothing to draw"));
    builder.document["meshes"][0]["primitives"][0].erase("attributes");
    EXPECT_EQ(refusal(builder), "test.gltf: mesh 0, primitive 0: attributes is missing");
}

TEST(GltfMesh, AnAttributeOfAnotherLengthIsLeftOut)
{
    for (const char* name : {"NORMAL", "TANGENT", "TEXCOORD_0", "TEXCOORD_1", "COLOR_0"}) {
        GltfBuilder builder = five_points(5);
        json& attributes = builder.document["meshes"][0]["primitives"][0]["attributes"];
        attributes[name] = std::string_view(name).starts_with("TEX")
                               ? builder.add_vec2({0, 0, 0, 0})
                               : builder.add_vec4({0, 0, 0, 0, 0, 0, 0, 0});
        EXPECT_EQ(complaint(builder), std::string("test.gltf: mesh 0, primitive 0, ") + name +
                                          " has 2 elements, POSITION has 5: left out");
    }
}

TEST(GltfMesh, PositionsThatAreNotFiniteAreRefused)
{
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
        GltfBuilder builder;
        builder.add_primitive(
            {{"attributes", {{"POSITION", builder.add_vec3({0, 0, 0, 1, 0, bad, 0, 1, 0})}}}});
        EXPECT_EQ(refusal(builder), "test.gltf: mesh 0, primitive 0: the position of vertex 1 is not finite");
    }
}

TEST(GltfMesh, TrianglesOfPositionsThatAreNotFiniteAreLeftOut)
{
    const float bad = std::numeric_limits<float>::quiet_NaN();
    GltfBuilder builder;
    const int positions = builder.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 5, bad, 0});
    builder.add_primitive(
        {{"attributes", {{"POSITION", positions}}}, {"indices", builder.add_indices({1, 2, 3, 0, 1, 2})}});
    const Scene scene = load(builder);
    EXPECT_EQ(triangle_count(scene), 1u);
    EXPECT_EQ(bounds(scene).high, glm::vec3(1, 1, 0)) << "nor does the vertex count elsewhere";
    EXPECT_EQ(complaint(builder),
              "test.gltf: 1 triangles, lines or points with positions that are not finite left out");
}

// Of the first mesh, whose vertices may have been renumbered.
std::vector<glm::vec3> corners_of(const Scene& scene)
{
    std::vector<glm::vec3> corners;
    const Mesh& mesh = scene.meshes.at(0);
    for (const glm::uvec3& triangle : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner)
            corners.push_back(mesh.positions[triangle[corner]]);
    return corners;
}

TEST(GltfMesh, RestartsEndTrianglesStripsAndFans)
{
    const auto with = [](int mode, const std::function<int(GltfBuilder&)>& indices) {
        return five_points(mode, indices);
    };
    const GltfBuilder strip = with(5, [](GltfBuilder& b) {
        return b.add_indices({0, 1, 2, 65535, 2, 3, 4});
    });
    EXPECT_EQ(load(strip).meshes.at(0).triangles, (Triangles{{0, 1, 2}, {2, 3, 4}}));
    EXPECT_EQ(complaint(strip),
              "test.gltf: 1 indices are the largest of their type, which restarts the primitive: "
              "triangles and lines end there");
    const GltfBuilder fan = with(6, [](GltfBuilder& b) {
        return b.add<std::uint32_t>("SCALAR", u32, {0, 1, 2, 4294967295u, 4294967295u, 1, 2, 3});
    });
    EXPECT_EQ(load(fan).meshes.at(0).triangles, (Triangles{{1, 2, 0}, {2, 3, 1}}));
    EXPECT_TRUE(complaint(fan).starts_with("test.gltf: 2 indices are the largest"));
    const GltfBuilder list = with(4, [](GltfBuilder& b) {
        return b.add<std::uint8_t>("SCALAR", u8, {0, 1, 255, 2, 3, 4});
    });
    EXPECT_EQ(corners_of(load(list)), corners_of(load(with(4, [](GltfBuilder& b) {
                  return b.add_indices({2, 3, 4});
              }))));
    // The largest number of another type is a vertex like others.
    GltfBuilder many;
    std::vector<float> corners(3 * 256);
    corners[3] = corners[3 * 255 + 1] = 1;
    const int positions = many.add_vec3(corners);
    many.add_primitive(
        {{"attributes", {{"POSITION", positions}}}, {"indices", many.add_indices({0, 1, 255})}});
    EXPECT_EQ(complaint(many), "");
    EXPECT_EQ(load(many).meshes.at(0).triangles.size(), 1u);
}

TEST(GltfMesh, AFileOfRestartsAloneIsNoError)
{
    GltfBuilder builder;
    const int positions = builder.add_vec3(std::vector<float>(3 * 256));
    builder.add_primitive({{"attributes", {{"POSITION", positions}}},
                           {"indices", builder.add<std::uint8_t>("SCALAR", u8, {0, 1, 255})}});
    Warnings warnings;
    EXPECT_TRUE(load(builder, &warnings).instances.empty());
    EXPECT_TRUE(warned_once(warnings, "1 indices are the largest of their type"));
    EXPECT_TRUE(warned_once(warnings, "nothing to draw"));
}

TEST(GltfMesh, ColorsAreClampedWithAWarning)
{
    GltfBuilder builder = triangle();
    builder.document["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] =
        builder.add_vec3({50, 0.5f, 0, 1, 1, 1, 1, -1, 0.25f});
    const Mesh mesh = load(builder).meshes.at(0);
    EXPECT_EQ(mesh.colors[0], glm::vec4(1, 0.5f, 0, 1));
    EXPECT_EQ(mesh.colors[1], glm::vec4(1));
    EXPECT_EQ(mesh.colors[2], glm::vec4(1, 0, 0.25f, 1));
    EXPECT_EQ(complaint(builder), "test.gltf: 2 vertex colours outside of 0 to 1 clamped");
}

TEST(GltfMesh, IndicesOfSparsePartsAlone)
{
    // Zeros, of which the sparse part replaces the first and the last: {2, 0, 1}.
    GltfBuilder builder = triangle();
    const int at = builder.add_view({0, 2});
    const int values = builder.add_view(bytes_of<std::uint16_t>({2, 1}));
    builder.document["meshes"][0]["primitives"][0]["indices"] =
        builder.add_to("accessors", {{"componentType", u16},
                                     {"count", 3},
                                     {"type", "SCALAR"},
                                     {"sparse",
                                      {{"count", 2},
                                       {"indices", {{"bufferView", at}, {"componentType", u8}}},
                                       {"values", {{"bufferView", values}}}}}});
    EXPECT_EQ(complaint(builder), "");
    EXPECT_EQ(corners_of(load(builder)), (std::vector<glm::vec3>{{0, 1, 0}, {0, 0, 0}, {1, 0, 0}}));
}

TEST(GltfMesh, AStrideThatIsNoMultipleOfFourIsRead)
{
    GltfBuilder builder;
    // Bytes, three of which are a position, two between them.
    const int positions =
        builder.add_accessor({"VEC3", u8, 3, false, 5}, {0, 0, 0, 9, 9, 1, 0, 0, 9, 9, 0, 1, 0});
    builder.add_primitive({{"attributes", {{"POSITION", positions}}}});
    EXPECT_EQ(load(builder).meshes.at(0).positions[2], glm::vec3(0, 1, 0));
}

TEST(GltfMesh, VerticesBeyondReasonAreRefused)
{
    GltfBuilder builder = triangle();
    builder.document["nodes"][0]["scale"] = {1e20, 1, 1};
    EXPECT_EQ(refusal(builder), "test.gltf: node 0: its vertices are more than 1e+18 m away");
}

TEST(GltfMesh, ColorsComeInEveryKind)
{
    const auto colors = [](const std::function<int(GltfBuilder&)>& add) {
        GltfBuilder builder = triangle();
        builder.document["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = add(builder);
        return load(builder).meshes.at(0).colors;
    };
    const auto rgb = colors([](GltfBuilder& b) { return b.add_vec3({0, 0.5f, 1, 1, 1, 1, 0.25f, 0, 0}); });
    ASSERT_EQ(rgb.size(), 3u);
    EXPECT_EQ(rgb[0], glm::vec4(0, 0.5f, 1, 1));
    EXPECT_EQ(rgb[2], glm::vec4(0.25f, 0, 0, 1));
    const auto rgba = colors([](GltfBuilder& b) {
        return b.add_vec4({0, 0, 0, 0.5f, 1, 1, 1, 1, 0, 0, 0, 0});
    });
    EXPECT_EQ(rgba[0], glm::vec4(0, 0, 0, 0.5f));
    const auto bytes = colors([](GltfBuilder& b) {
        return b.add<std::uint8_t>("VEC4", u8, {51, 0, 255, 102, 0, 0, 0, 0, 0, 0, 0, 0}, true);
    });
    EXPECT_NEAR(bytes[0].x, 0.2f, 1e-6f);
    EXPECT_NEAR(bytes[0].w, 0.4f, 1e-6f);
    const auto shorts = colors([](GltfBuilder& b) {
        return b.add_accessor({"VEC3", u16, 3, true, 8},
                              bytes_of<std::uint16_t>({13107, 0, 65535, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
    });
    EXPECT_NEAR(shorts[0].x, 0.2f, 1e-6f);
    EXPECT_EQ(shorts[0].w, 1.0f);
}

TEST(GltfMesh, BothSetsOfTextureCoordinatesAreRead)
{
    GltfBuilder builder = five_points(4);
    json& attributes = builder.document["meshes"][0]["primitives"][0]["attributes"];
    attributes["TEXCOORD_0"] = builder.add_vec2({0, 0, 0, 1, 1, 0, 1, 1, 0.5f, 2});
    attributes["TEXCOORD_1"] = builder.add<std::uint8_t>("VEC2", u8, {0, 0, 255, 51, 0, 0, 0, 0, 0, 0}, true);
    // Used by nothing the loader reads, and not even a texture coordinate.
    attributes["TEXCOORD_2"] = attributes["POSITION"];
    attributes["_BATCHID"] = 99;
    const Mesh mesh = load(builder).meshes.at(0);
    ASSERT_EQ(mesh.texcoords[0].size(), mesh.positions.size());
    ASSERT_EQ(mesh.texcoords[1].size(), mesh.positions.size());
    EXPECT_EQ(mesh.texcoords[0][1], glm::vec2(0, 1));
    EXPECT_EQ(mesh.texcoords[1][1], glm::vec2(1, 0.2f));
}

// Five textures may read five sets, one of them by KHR_texture_transform's word; tangents are made from the normal
// texture's. What no texture reads may be of any kind.
TEST(GltfMesh, AnySetOfTextureCoordinatesThatAMaterialAsksForIsRead)
{
    GltfBuilder builder = five_points(5);
    builder.add_to("images", {{"bufferView", builder.add_view(make_png({1, 1, 8, {1, 2, 3, 4}}))}});
    builder.add_to("textures", {{"source", 0}});
    const auto use = [](int set) { return json{{"index", 0}, {"texCoord", set}}; };
    json moved = use(1);
    moved["extensions"]["KHR_texture_transform"]["texCoord"] = 12;
    builder.add_to("materials", {{"pbrMetallicRoughness",
                                  {{"baseColorTexture", use(2)}, {"metallicRoughnessTexture", use(3)}}},
                                 {"normalTexture", use(5)},
                                 {"occlusionTexture", use(7)},
                                 {"emissiveTexture", moved}});
    json& primitive = builder.document["meshes"][0]["primitives"][0];
    primitive["material"] = 0;
    primitive["attributes"]["TEXCOORD_4"] = primitive["attributes"]["POSITION"];
    for (const int set : {2, 3, 5, 7, 12}) {
        const auto u = static_cast<float>(set);
        primitive["attributes"]["TEXCOORD_" + std::to_string(set)] =
            builder.add_vec2({u, 0, u, 1, u + 1, 0, 0, 0, 0, 0});
    }
    Warnings warnings;
    const Scene scene = load(builder, &warnings);
    EXPECT_EQ(warnings, Warnings());
    const Mesh& mesh = scene.meshes.at(0);
    for (const int set : {2, 3, 5, 7, 12}) {
        ASSERT_EQ(mesh.texcoords[set].size(), mesh.positions.size()) << set;
        EXPECT_EQ(mesh.texcoords[set][1], glm::vec2(set, 1));
    }
    EXPECT_TRUE(mesh.texcoords[4].empty());
    EXPECT_EQ(mesh.tangents.size(), mesh.positions.size());
    EXPECT_EQ(scene.materials.at(0).emissive_texture.texcoord, 12);
    EXPECT_EQ(scene.materials.at(0).occlusion_texture.texcoord, 7);
    primitive["attributes"].erase("TEXCOORD_7");
    load(builder, &warnings);
    EXPECT_TRUE(warned_once(warnings, "1 primitives have textures but not their texture coordinates"));
}

TEST(GltfMesh, MissingNormalsBecomeFlat)
{
    // Two triangles share an edge at a right angle: the floor and a wall.
    GltfBuilder builder;
    const int positions = builder.add_vec3({0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 1, 0});
    const int indices = builder.add_indices({0, 1, 2, 0, 1, 3});
    const int colors = builder.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    builder.add_primitive(
        {{"attributes", {{"POSITION", positions}, {"COLOR_0", colors}}}, {"indices", indices}});
    const Mesh mesh = load(builder).meshes.at(0);
    ASSERT_EQ(mesh.positions.size(), 6u);
    ASSERT_EQ(mesh.normals.size(), 6u);
    for (int corner = 0; corner < 3; ++corner) {
        EXPECT_EQ(mesh.normals[mesh.triangles[0][corner]], glm::vec3(0, 1, 0));
        EXPECT_EQ(mesh.normals[mesh.triangles[1][corner]], glm::vec3(0, 0, 1));
    }
    EXPECT_EQ(mesh.positions[mesh.triangles[1].z], glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.colors[mesh.triangles[1].z], glm::vec4(0, 0, 1, 1));
}

TEST(GltfMesh, NormalsAreBroughtToUnitLengthAndTangentsWithThem)
{
    GltfBuilder builder = triangle();
    json& attributes = builder.document["meshes"][0]["primitives"][0]["attributes"];
    attributes["NORMAL"] = builder.add_vec3({0, 0, 5, 0, 3, 4, 0, 0, 0});
    attributes["TANGENT"] = builder.add_vec4({2, 0, 0, 0.5f, 0, 4, -3, -3, 0, 0, 0, 1});
    Warnings warnings;
    const Mesh mesh = load(builder, &warnings).meshes.at(0);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    EXPECT_NEAR(mesh.normals[1].y, 0.6f, 1e-6f);
    EXPECT_EQ(mesh.normals[2], glm::vec3(0, 0, 1)) << "rebuilt from the face";
    EXPECT_EQ(mesh.tangents[0], glm::vec4(1, 0, 0, 1));
    EXPECT_NEAR(mesh.tangents[1].y, 0.8f, 1e-6f);
    EXPECT_EQ(mesh.tangents[1].w, -1.0f);
    EXPECT_NEAR(glm::length(glm::vec3(mesh.tangents[2])), 1.0f, 1e-6f);
    EXPECT_TRUE(warned_once(warnings, "1 normals without length rebuilt"));
    EXPECT_TRUE(warned_once(warnings, "1 unusable tangents replaced"));
}

TEST(GltfMesh, TangentsWithoutNormalsAreIgnored)
{
    GltfBuilder builder = triangle();
    builder.document["meshes"][0]["primitives"][0]["attributes"]["TANGENT"] =
        builder.add_vec4({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
    EXPECT_TRUE(load(builder).meshes.at(0).tangents.empty());
}

TEST(GltfMesh, QuantizedNormalsAndTangentsAreDirections)
{
    GltfBuilder builder = triangle();
    json& attributes = builder.document["meshes"][0]["primitives"][0]["attributes"];
    attributes["NORMAL"] = builder.add_accessor(
        {"VEC3", i8, 3, true, 4}, bytes_of<std::int8_t>({0, 0, 127, 0, 0, 127, 0, 0, 90, 0, 90, 0}));
    attributes["TANGENT"] = builder.add<std::int16_t>(
        "VEC4", i16, {32767, 0, 0, 32767, 0, 0, -32767, -32767, 0, 20000, 0, 32767}, true);
    const Mesh mesh = load(builder).meshes.at(0);
    EXPECT_EQ(mesh.normals[1], glm::vec3(0, 1, 0));
    EXPECT_NEAR(mesh.normals[2].x, 0.70710678f, 1e-6f);
    EXPECT_EQ(mesh.tangents[1], glm::vec4(0, 0, -1, -1));
    EXPECT_EQ(mesh.tangents[2], glm::vec4(0, 1, 0, 1));
}

TEST(GltfMesh, TextureCoordinatesAndColorsThatAreNotFiniteAreReplaced)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    GltfBuilder builder = triangle();
    json& attributes = builder.document["meshes"][0]["primitives"][0]["attributes"];
    attributes["TEXCOORD_0"] = builder.add_vec2({nan, 1, 0, 1, 1, 1});
    attributes["COLOR_0"] = builder.add_vec3({1, 0, 0, nan, 0, 0, nan, 0, 0});
    Warnings warnings;
    const Mesh mesh = load(builder, &warnings).meshes.at(0);
    EXPECT_EQ(mesh.texcoords[0][0], glm::vec2(0));
    EXPECT_EQ(mesh.texcoords[0][1], glm::vec2(0, 1));
    EXPECT_EQ(mesh.colors[0], glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(mesh.colors[1], glm::vec4(1));
    EXPECT_TRUE(warned_once(warnings, "1 texture coordinates"));
    EXPECT_TRUE(warned_once(warnings, "2 vertex colours"));
}

TEST(GltfMesh, GeometryOnlyInDracoIsRefused)
{
    GltfBuilder builder = triangle();
    builder.document["accessors"][0].erase("bufferView");
    builder.document["meshes"][0]["primitives"][0]["extensions"] = {
        {"KHR_draco_mesh_compression", {{"bufferView", 0}}}};
    EXPECT_EQ(refusal(builder),
              "test.gltf: mesh 0, primitive 0: its geometry is compressed by KHR_draco_mesh_compression, "
              "which is not supported");
}

TEST(GltfMesh, EmptyThingsAreNoHarm)
{
    GltfBuilder builder;
    builder.document["accessors"] = {{{"componentType", f32}, {"count", 0}, {"type", "VEC3"}},
                                     {{"componentType", u16}, {"count", 0}, {"type", "SCALAR"}}};
    builder.document["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}},
                                  {{"primitives", json::array()}},
                                  json::object()};
    for (const int mesh : {0, 1, 2})
        builder.add_node({{"mesh", mesh}});
    Warnings warnings;
    const Scene scene = load(builder, &warnings);
    EXPECT_TRUE(scene.instances.empty());
    EXPECT_EQ(scene.materials.size(), 1u);
    EXPECT_TRUE(warned_once(warnings, "nothing to draw"));
    // A view of no bytes, and a triangle list of no indices.
    GltfBuilder indexed = triangle();
    indexed.document["meshes"][0]["primitives"][0]["indices"] = indexed.add_indices({});
    EXPECT_TRUE(load(indexed).instances.empty());
}

} // namespace
} // namespace lambent::scene::test
