// Morph targets at their default weights, skins in their rest pose.
#include "tests/scene/gltf_builder.h"

#include <gtest/gtest.h>

namespace lambent::scene::test {
namespace {

using Points = std::vector<glm::vec3>;

void expect_near(const Points& points, const Points& expected)
{
    ASSERT_EQ(points.size(), expected.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(points[i][axis], expected[i][axis], 1e-6f) << "point " << i << ", axis " << axis;
}

GltfBuilder morphed_triangle()
{
    GltfBuilder builder = triangle();
    json& primitive = builder.document["meshes"][0]["primitives"][0];
    const int up = builder.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int right = builder.add_vec3({2, 0, 0, 2, 0, 0, 2, 0, 0});
    primitive["targets"] = {{{"POSITION", up}}, {{"POSITION", right}}};
    return builder;
}

TEST(GltfMorph, DefaultWeightsOfTheMeshApply)
{
    GltfBuilder builder = morphed_triangle();
    builder.document["meshes"][0]["weights"] = {0.5, -1};
    expect_near(load(builder).meshes.at(0).positions, {{-2, 0, 0.5f}, {-1, 0, 0.5f}, {-2, 1, 0.5f}});
}

TEST(GltfMorph, WithoutWeightsNothingMoves)
{
    expect_near(load(morphed_triangle()).meshes.at(0).positions, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
}

TEST(GltfMorph, ANodesOwnWeightsMakeAMeshOfItsOwn)
{
    GltfBuilder builder = morphed_triangle();
    builder.document["meshes"][0]["weights"] = {1, 0};
    builder.add_node({{"mesh", 0}});
    builder.add_node({{"mesh", 0}, {"weights", {0, 1}}});
    const Scene scene = load(builder);
    ASSERT_EQ(scene.instances.size(), 3u);
    EXPECT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.instances[0].mesh, scene.instances[1].mesh);
    EXPECT_EQ(scene.meshes.at(static_cast<std::size_t>(scene.instances[0].mesh)).positions[0],
              glm::vec3(0, 0, 1));
    EXPECT_EQ(scene.meshes.at(static_cast<std::size_t>(scene.instances[2].mesh)).positions[0],
              glm::vec3(2, 0, 0));
}

TEST(GltfMorph, NormalsAndTangentsMoveToo)
{
    GltfBuilder builder = triangle();
    json& primitive = builder.document["meshes"][0]["primitives"][0];
    primitive["attributes"]["NORMAL"] = builder.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});
    primitive["attributes"]["TANGENT"] = builder.add_vec4({1, 0, 0, -1, 1, 0, 0, -1, 1, 0, 0, -1});
    primitive["targets"] = {{{"NORMAL", builder.add_vec3({0, 1, -1, 0, 1, -1, 0, 1, -1})},
                             {"TANGENT", builder.add_vec3({-1, 0, 1, -1, 0, 1, -1, 0, 1})}}};
    builder.document["meshes"][0]["weights"] = {1};
    const Mesh mesh = load(builder).meshes.at(0);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.tangents[0], glm::vec4(0, 0, 1, -1));
}

TEST(GltfMorph, FlatNormalsAreThoseOfTheMovedFaces)
{
    GltfBuilder builder = triangle();
    json& primitive = builder.document["meshes"][0]["primitives"][0];
    // The third corner moves from (0, 1, 0) to (0, 0, -1): the triangle lies down.
    primitive["targets"] = {{{"POSITION", builder.add_vec3({0, 0, 0, 0, 0, 0, 0, -1, -1})}}};
    builder.document["meshes"][0]["weights"] = {1};
    EXPECT_EQ(load(builder).meshes.at(0).normals[0], glm::vec3(0, 1, 0));
}

TEST(GltfMorph, TargetsOfOtherAttributesAreWarnedOf)
{
    GltfBuilder builder = morphed_triangle();
    json& primitive = builder.document["meshes"][0]["primitives"][0];
    primitive["attributes"]["TEXCOORD_0"] = builder.add_vec2({0, 0, 1, 0, 0, 1});
    primitive["targets"][0]["TEXCOORD_0"] = builder.add_vec2({1, 1, 1, 1, 1, 1});
    Warnings warnings;
    load(builder, &warnings);
    EXPECT_TRUE(warnings.empty()) << "its weight is 0";
    builder.document["meshes"][0]["weights"] = {1, 0};
    EXPECT_EQ(load(builder, &warnings).meshes.at(0).texcoords[0][0], glm::vec2(0));
    EXPECT_EQ(warnings, Warnings{"test.gltf: 1 morph targets of texture coordinates or colours left out"});
}

TEST(GltfMorph, BrokenTargetsAreLeftOut)
{
    GltfBuilder builder = morphed_triangle();
    builder.document["meshes"][0]["weights"] = {1, 1};
    builder.document["accessors"][1]["count"] = 2;
    EXPECT_EQ(complaint(builder),
              "test.gltf: mesh 0, primitive 0, target 0 POSITION has 2 elements, POSITION has 3: left out");
    builder.document["accessors"][1]["count"] = 4;
    EXPECT_EQ(complaint(builder),
              "test.gltf: mesh 0, primitive 0, target 0 POSITION has 4 elements, POSITION has 3: left out");
    builder.document["meshes"][0]["primitives"][0]["targets"][0]["POSITION"] = 50;
    EXPECT_EQ(complaint(builder),
              "test.gltf: mesh 0, primitive 0, target 0 POSITION: accessor 50 does not exist: left out");
}

// Vertex 0 follows joint 0, vertex 1 joint 1, vertex 2 both by half. Joint 0 is node 1, lifted by 10; joint 1
// is its child, node 2, moved by (1, 0, 0) and twice as large.
GltfBuilder skinned_triangle()
{
    GltfBuilder builder = triangle();
    json& attributes = builder.document["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = builder.add<std::uint8_t>("VEC4", u8, {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0});
    attributes["WEIGHTS_0"] = builder.add_vec4({1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0});
    builder.document["nodes"][0]["skin"] = 0;
    // A skinned mesh does not follow its own node. [glTF 2.0, 3.7.3.3]
    builder.document["nodes"][0]["translation"] = {100, 100, 100};
    builder.add_node({{"translation", {0, 10, 0}}, {"children", {2}}});
    builder.document["nodes"].push_back({{"translation", {1, 0, 0}}, {"scale", {2, 2, 2}}});
    builder.document["skins"] = {{{"joints", {1, 2}}}};
    return builder;
}

TEST(GltfSkin, VerticesFollowTheirJoints)
{
    const Scene scene = load(skinned_triangle());
    ASSERT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(scene.instances[0].transform, glm::mat4(1.0f));
    // (0,0,0) + (0,10,0); 2 (1,0,0) + (1,10,0); half of (0,1,0) + (0,10,0), half of 2 (0,1,0) + (1,10,0)
    expect_near(scene.meshes.at(0).positions, {{0, 10, 0}, {3, 10, 0}, {0.5f, 11.5f, 0}});
}

TEST(GltfSkin, InverseBindMatricesComeFirst)
{
    GltfBuilder builder = skinned_triangle();
    std::vector<float> matrices = {1,    0, 0, 0, 0, 1,    0, 0, 0, 0, 1,    0, 0,     -10, 0, 1,
                                   0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, 0.5f, 0, -0.5f, -5,  0, 1};
    builder.document["skins"][0]["inverseBindMatrices"] = builder.add("MAT4", f32, matrices);
    // They undo the joints' transforms: every vertex is back where it was.
    expect_near(load(builder).meshes.at(0).positions, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
}

TEST(GltfSkin, ASecondSetOfInfluencesAndUnevenSums)
{
    GltfBuilder builder = skinned_triangle();
    json& attributes = builder.document["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_1"] = builder.add<std::uint16_t>("VEC4", u16, {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    attributes["WEIGHTS_1"] =
        builder.add<std::uint8_t>("VEC4", u8, {255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, true);
    // Vertex 0: weights 1 and 1, that is half (0, 10, 0) and half (1, 10, 0).
    expect_near(load(builder).meshes.at(0).positions, {{0.5f, 10, 0}, {3, 10, 0}, {0.5f, 11.5f, 0}});
}

TEST(GltfSkin, AMirroringSkeletonTurnsTheTrianglesOver)
{
    GltfBuilder builder = skinned_triangle();
    json& attributes = builder.document["meshes"][0]["primitives"][0]["attributes"];
    attributes["NORMAL"] = builder.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});
    attributes["TANGENT"] = builder.add_vec4({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
    builder.document["nodes"][1]["scale"] = {-1, 1, 1};
    const Mesh mesh = load(builder).meshes.at(0);
    EXPECT_EQ(mesh.triangles[0], glm::uvec3(0, 2, 1));
    const glm::uvec3 t = mesh.triangles[0];
    const glm::vec3 face =
        glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
    EXPECT_GT(face.z, 0.0f) << "the front still faces +Z";
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.tangents[0], glm::vec4(-1, 0, 0, -1)) << "cross(normal, tangent) * w is still +Y";
}

TEST(GltfSkin, NormalsOfAStretchedSurfaceStayPerpendicular)
{
    GltfBuilder builder = skinned_triangle();
    json& attributes = builder.document["meshes"][0]["primitives"][0]["attributes"];
    attributes["POSITION"] = builder.add_vec3({0, 0, 0, 1, 0, -1, 0, 1, 0}); // in the plane x + z = 0
    attributes["NORMAL"] = builder.add_vec3({1, 0, 1, 1, 0, 1, 1, 0, 1});
    attributes["WEIGHTS_0"] = builder.add_vec4({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    attributes["JOINTS_0"] = builder.add<std::uint8_t>("VEC4", u8, std::vector<std::uint8_t>(12, 0));
    builder.document["nodes"][1]["scale"] = {3, 1, 1};
    const Mesh mesh = load(builder).meshes.at(0);
    // The stretched plane is x / 3 + z = 0.
    EXPECT_NEAR(mesh.normals[0].x * 3.0f, mesh.normals[0].z, 1e-6f);
    EXPECT_NEAR(glm::length(mesh.normals[0]), 1.0f, 1e-6f);
}

TEST(GltfSkin, APrimitiveWithoutInfluencesFollowsItsNode)
{
    GltfBuilder builder = skinned_triangle();
    builder.document["meshes"][0]["primitives"][0]["attributes"].erase("JOINTS_0");
    const Scene scene = load(builder);
    EXPECT_EQ(scene.origin + glm::dvec3(glm::vec3(scene.instances.at(0).transform[3])), glm::dvec3(100.0));
}

TEST(GltfSkin, BrokenSkinsAreLeftOut)
{
    const auto broken = [](const std::function<void(GltfBuilder&)>& damage) {
        GltfBuilder builder = skinned_triangle();
        damage(builder);
        return complaint(builder);
    };
    EXPECT_EQ(broken([](GltfBuilder& b) { b.document["nodes"][0]["skin"] = 3; }),
              "test.gltf: skin 3 does not exist: drawn without the skin");
    EXPECT_EQ(broken([](GltfBuilder& b) { b.document["skins"][0]["joints"] = {1}; }),
              "test.gltf: mesh 0, primitive 0: joint 1 is past the skin's 1 joints: drawn without the skin");
    EXPECT_EQ(broken([](GltfBuilder& b) {
                  b.document["skins"][0]["joints"] = {1, 77};
              }),
              "test.gltf: skin 0: joint node 77 does not exist: drawn without the skin");
    EXPECT_EQ(broken([](GltfBuilder& b) { b.document["skins"][0].erase("joints"); }),
              "test.gltf: skin 0: joints is missing: left out");
    EXPECT_EQ(broken([](GltfBuilder& b) {
                  b.document["skins"][0]["inverseBindMatrices"] =
                      b.add("MAT4", f32, std::vector<float>(16, 0.0f));
              }),
              "test.gltf: skin 0: 1 inverse bind matrices for 2 joints: drawn without the skin");
    EXPECT_EQ(broken([](GltfBuilder& b) { b.document["skins"][0]["inverseBindMatrices"] = 0; }),
              "test.gltf: skin 0, inverseBindMatrices: accessor 0 is not MAT4: drawn without the skin");
    EXPECT_EQ(broken([](GltfBuilder& b) {
                  b.document["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] =
                      b.add_vec4(std::vector<float>(12, 0.0f));
              }),
              "test.gltf: mesh 0, primitive 0, JOINTS_0: accessor 3 has componentType 5126, which is not "
              "allowed: drawn without the skin");
}

} // namespace
} // namespace lambent::scene::test
