// Accessors: every kind of number, stride, sparse parts, and what does not fit.
#include "tests/scene/gltf_builder.h"

#include <gtest/gtest.h>

#include <array>

namespace lambent::scene::test {
namespace {

// The triangle's attributes with positions of another kind.
Mesh mesh_with(const char* attribute, const std::function<int(GltfBuilder&)>& add)
{
    GltfBuilder builder = triangle();
    const int accessor = add(builder);
    builder.document["meshes"][0]["primitives"][0]["attributes"][attribute] = accessor;
    return load(builder).meshes.at(0);
}

void expect_near(glm::vec3 a, glm::vec3 b, float bound = 1e-6f)
{
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(a[i], b[i], bound) << "component " << i;
}

TEST(GltfAccessor, IntegerPositionsKeepTheirValue)
{
    const auto bytes = mesh_with("POSITION", [](GltfBuilder& b) {
        return b.add_accessor({"VEC3", i8, 3, false, 4},
                              bytes_of<std::int8_t>({-128, 127, 0, 9, 1, 2, 3, 9, 4, 5, 6, 9}));
    });
    EXPECT_EQ(bytes.positions[0], glm::vec3(-128, 127, 0));
    EXPECT_EQ(bytes.positions[2], glm::vec3(4, 5, 6));
    const auto shorts = mesh_with("POSITION", [](GltfBuilder& b) {
        return b.add_accessor({"VEC3", u16, 3, false, 8},
                              bytes_of<std::uint16_t>({65535, 0, 1, 9, 2, 3, 4, 9, 5, 6, 7, 9}));
    });
    EXPECT_EQ(shorts.positions[0], glm::vec3(65535, 0, 1));
    EXPECT_EQ(shorts.positions[1], glm::vec3(2, 3, 4));
}

TEST(GltfAccessor, NormalizedIntegersAreFractions)
{
    // f = max(c / 127, -1), c / 255, max(c / 32767, -1), c / 65535 [glTF 2.0, 3.6.2.2]
    const auto i8s = mesh_with("POSITION", [](GltfBuilder& b) {
        return b.add<std::int8_t>("VEC3", i8, {-128, -127, 127, 0, 64, 1, 0, 0, 0}, true);
    });
    expect_near(i8s.positions[0], {-1, -1, 1});
    expect_near(i8s.positions[1], {0, 64.0f / 127.0f, 1.0f / 127.0f});
    const auto u8s = mesh_with("POSITION", [](GltfBuilder& b) {
        return b.add<std::uint8_t>("VEC3", u8, {255, 51, 0, 1, 2, 3, 0, 0, 0}, true);
    });
    expect_near(u8s.positions[0], {1, 0.2f, 0});
    const auto i16s = mesh_with("POSITION", [](GltfBuilder& b) {
        return b.add<std::int16_t>("VEC3", i16, {-32768, -32767, 32767, 0, 1, 2, 0, 0, 0}, true);
    });
    expect_near(i16s.positions[0], {-1, -1, 1});
    const auto u16s = mesh_with("POSITION", [](GltfBuilder& b) {
        return b.add<std::uint16_t>("VEC3", u16, {65535, 13107, 0, 1, 2, 3, 0, 0, 0}, true);
    });
    expect_near(u16s.positions[0], {1, 0.2f, 0});
}

TEST(GltfAccessor, StrideAndOffsetInterleave)
{
    GltfBuilder builder;
    // position, normal, position, normal ...
    const int view =
        builder.add_view(bytes_of<float>({0, 0, 0, 0, 0, 2, 1, 0, 0, 0, 0, 3, 0, 1, 0, 0, 0, 4}), 24);
    builder.document["accessors"] = {
        {{"bufferView", view}, {"componentType", f32}, {"count", 3}, {"type", "VEC3"}},
        {{"bufferView", view}, {"byteOffset", 12}, {"componentType", f32}, {"count", 3}, {"type", "VEC3"}}};
    builder.add_primitive({{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}});
    const Mesh mesh = load(builder).meshes.at(0);
    EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.normals, (std::vector<glm::vec3>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}));
}

// Three positions, `stride` bytes apart, in as many bytes as they need and `more`. [glTF 2.0, 3.6.2.4: the last element is
// not followed by the rest of a stride]
GltfBuilder positions_apart(std::size_t stride, int more)
{
    GltfBuilder builder = triangle();
    Bytes bytes;
    for (const float i : {0.0f, 1.0f, 2.0f}) {
        const Bytes one = bytes_of<float>({10 * i + 1, 10 * i + 2, 10 * i + 3});
        bytes.insert(bytes.end(), one.begin(), one.end());
        if (i < 2.0f)
            bytes.resize(bytes.size() + stride - one.size(), 0xEE);
    }
    bytes.resize(bytes.size() + static_cast<std::size_t>(more), 0xEE);
    const int view = builder.add_view(bytes, stride);
    builder.document["accessors"][0]["bufferView"] = view;
    return builder;
}

TEST(GltfAccessor, EveryStrideIsTakenAsItIs)
{
    for (const std::size_t stride : {12, 16, 20, 24, 100, 252})
        for (const int more : {0, 1}) {
            const Mesh mesh = load(positions_apart(stride, more)).meshes.at(0);
            EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{1, 2, 3}, {11, 12, 13}, {21, 22, 23}}))
                << stride;
        }
    // A byte too few for the last element.
    GltfBuilder cut = positions_apart(16, 0);
    cut.document["bufferViews"].back()["byteLength"] = 43;
    EXPECT_TRUE(contains(refusal(cut), "3 elements of 12 bytes do not fit in bufferView")) << refusal(cut);
    // Of one element alone.
    GltfBuilder one = positions_apart(16, 0);
    one.document["accessors"][0]["count"] = 1;
    one.document["bufferViews"].back()["byteLength"] = 11;
    EXPECT_TRUE(contains(refusal(one), "1 elements of 12 bytes do not fit in bufferView")) << refusal(one);
    for (const std::size_t stride : {4, 8}) {
        GltfBuilder overlap = positions_apart(12, 0);
        overlap.document["bufferViews"].back()["byteStride"] = stride;
        EXPECT_TRUE(contains(refusal(overlap), "elements of 12 bytes overlap")) << stride;
    }
}

// So are strides of what is not floats, and of vertices of which only some are read.
TEST(GltfAccessor, StridesOfBytesAndOfSelectedVertices)
{
    const auto bytes = mesh_with("POSITION", [](GltfBuilder& b) {
        return b.add_accessor({"VEC3", u8, 3, false, 8},
                              bytes_of<std::uint8_t>({1,  2,  3,  99, 99, 99, 99, 99, 4,  5,  6,  99,
                                                      99, 99, 99, 99, 7,  8,  9,  99, 99, 99, 99, 99}));
    });
    EXPECT_EQ(bytes.positions, (std::vector<glm::vec3>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
    GltfBuilder builder;
    std::vector<float> numbers;
    for (int i = 0; i < 8; ++i)
        numbers.insert(numbers.end(), {static_cast<float>(i), static_cast<float>(i * i), 0.5f, 99.0f});
    const int view = builder.add_view(bytes_of(numbers), 16);
    const int positions = builder.add_to(
        "accessors", {{"bufferView", view}, {"componentType", f32}, {"count", 8}, {"type", "VEC3"}});
    builder.add_primitive(
        {{"attributes", {{"POSITION", positions}}}, {"indices", builder.add_indices({7, 2, 5})}});
    const Mesh mesh = load(builder).meshes.at(0);
    ASSERT_EQ(mesh.triangles.size(), 1u);
    EXPECT_EQ(mesh.positions[mesh.triangles[0].x], glm::vec3(7, 49, 0.5f));
    EXPECT_EQ(mesh.positions[mesh.triangles[0].y], glm::vec3(2, 4, 0.5f));
    EXPECT_EQ(mesh.positions[mesh.triangles[0].z], glm::vec3(5, 25, 0.5f));
}

TEST(GltfAccessor, BytesNeedNotBeAligned)
{
    GltfBuilder builder;
    Bytes bytes = {0xEE};
    const Bytes floats = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
    bytes.insert(bytes.end(), floats.begin(), floats.end());
    const int view = builder.add_view(bytes);
    builder.add_to(
        "accessors",
        {{"bufferView", view}, {"byteOffset", 1}, {"componentType", f32}, {"count", 3}, {"type", "VEC3"}});
    builder.add_primitive({{"attributes", {{"POSITION", 0}}}});
    EXPECT_EQ(load(builder).meshes.at(0).positions[1], glm::vec3(1, 0, 0));
}

// Adds sparse elements to an accessor of the builder.
void make_sparse(GltfBuilder& builder, int accessor, const std::vector<std::uint16_t>& elements,
                 const std::vector<float>& values)
{
    const int indices = builder.add_view(bytes_of(elements));
    const int replaced = builder.add_view(bytes_of(values));
    builder.document["accessors"][static_cast<std::size_t>(accessor)]["sparse"] = {
        {"count", elements.size()},
        {"indices", {{"bufferView", indices}, {"componentType", u16}}},
        {"values", {{"bufferView", replaced}}}};
}

TEST(GltfAccessor, SparseElementsReplaceOthers)
{
    GltfBuilder builder = triangle();
    make_sparse(builder, 0, {0, 2}, {7, 8, 9, 4, 5, 6});
    EXPECT_EQ(load(builder).meshes.at(0).positions,
              (std::vector<glm::vec3>{{7, 8, 9}, {1, 0, 0}, {4, 5, 6}}));
}

TEST(GltfAccessor, WithoutBufferViewEverythingIsZero)
{
    GltfBuilder builder = triangle();
    builder.document["accessors"][0].erase("bufferView");
    make_sparse(builder, 0, {1}, {1, 2, 3});
    EXPECT_EQ(load(builder).meshes.at(0).positions,
              (std::vector<glm::vec3>{{0, 0, 0}, {1, 2, 3}, {0, 0, 0}}));
    builder.document["accessors"][0].erase("sparse");
    EXPECT_EQ(load(builder).meshes.at(0).positions, std::vector<glm::vec3>(3, glm::vec3(0)));
}

TEST(GltfAccessor, SparseElementsReachOnlyTheVerticesThatAreRead)
{
    // Eight vertices, of which one triangle uses 1, 4 and 6: the reader gathers those.
    GltfBuilder builder;
    std::vector<float> numbers;
    for (int i = 0; i < 8; ++i)
        numbers.insert(numbers.end(), {static_cast<float>(i), static_cast<float>(i * i), 0.0f});
    const int positions = builder.add_vec3(numbers);
    make_sparse(builder, positions, {2, 4, 7}, {-2, -2, -2, -4, -4, -4, -7, -7, -7});
    const int indices = builder.add_indices({6, 1, 4});
    builder.add_primitive({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
    const Mesh mesh = load(builder).meshes.at(0);
    ASSERT_EQ(mesh.triangles.size(), 1u);
    const glm::uvec3 t = mesh.triangles[0];
    EXPECT_EQ(mesh.positions.size(), 3u);
    EXPECT_EQ(mesh.positions[t.x], glm::vec3(6, 36, 0));
    EXPECT_EQ(mesh.positions[t.y], glm::vec3(1, 1, 0));
    EXPECT_EQ(mesh.positions[t.z], glm::vec3(-4, -4, -4));
}

TEST(GltfAccessor, SparsePartsAreChecked)
{
    const auto broken = [](const std::function<void(json&)>& damage) {
        GltfBuilder builder = triangle();
        make_sparse(builder, 0, {0, 2}, {7, 8, 9, 4, 5, 6});
        damage(builder.document["accessors"][0]["sparse"]);
        return refusal(builder);
    };
    EXPECT_EQ(broken([](json& s) { s["count"] = 4; }),
              "test.gltf: accessor 0: more sparse elements (4) than elements (3)");
    EXPECT_EQ(broken([](json& s) { s["count"] = 3; }),
              "test.gltf: accessor 0, sparse indices: 3 elements of 2 bytes "
              "do not fit in bufferView 1 (4 bytes)");
    EXPECT_EQ(broken([](json& s) { s["indices"]["componentType"] = f32; }),
              "test.gltf: accessor 0: sparse indices have componentType 5126, which is not allowed");
    EXPECT_EQ(
        broken([](json& s) { s["values"]["byteOffset"] = 4; }),
        "test.gltf: accessor 0, sparse values: 2 elements of 12 bytes do not fit in bufferView 2 (24 bytes)");
    EXPECT_EQ(broken([](json& s) { s["values"]["bufferView"] = 9; }),
              "test.gltf: accessor 0, sparse values: bufferView 9 does not exist");
    GltfBuilder partless = triangle();
    make_sparse(partless, 0, {0, 2}, {7, 8, 9, 4, 5, 6});
    partless.document["accessors"][0]["sparse"].erase("indices");
    EXPECT_EQ(complaint(partless), "test.gltf: accessor 0, sparse: indices is missing: ignored");

    GltfBuilder builder = triangle();
    make_sparse(builder, 0, {0, 3}, {7, 8, 9, 4, 5, 6});
    EXPECT_EQ(refusal(builder), "test.gltf: accessor 0: sparse index 3 is past its 3 elements");
}

TEST(GltfAccessor, OneThatDoesNotFitIsRefused)
{
    const auto broken = [](const char* property, const json& value) {
        GltfBuilder builder = triangle();
        builder.document["accessors"][0][property] = value;
        return refusal(builder);
    };
    EXPECT_EQ(broken("count", 4),
              "test.gltf: accessor 0: 4 elements of 12 bytes do not fit in bufferView 0 (36 bytes)");
    EXPECT_EQ(broken("byteOffset", 4),
              "test.gltf: accessor 0: 3 elements of 12 bytes do not fit in bufferView 0 (36 bytes)");
    EXPECT_EQ(broken("byteOffset", 9007199254740992),
              "test.gltf: accessor 0: 3 elements of 12 bytes do not fit in bufferView 0 (36 bytes)");
    EXPECT_EQ(broken("count", 1537228672809129303), // times 12 is 20 in 64 bits
              "test.gltf: accessor 0: count is not a whole number from 0 to 9007199254740992");
    EXPECT_EQ(broken("bufferView", 1), "test.gltf: accessor 0: bufferView 1 does not exist");
    EXPECT_EQ(broken("componentType", 5124),
              "test.gltf: accessor 0: componentType 5124 is not defined by glTF");
    EXPECT_EQ(broken("componentType", 5130),
              "test.gltf: accessor 0: componentType 5130 is not defined by glTF");
    EXPECT_EQ(broken("type", "VEC2"), "test.gltf: mesh 0, primitive 0, POSITION: accessor 0 is not VEC3");
    EXPECT_EQ(broken("type", "VEC5"), "test.gltf: accessor 0: type \"VEC5\" is not defined by glTF");

    GltfBuilder view = triangle();
    view.document["bufferViews"][0]["byteLength"] = 37;
    EXPECT_EQ(refusal(view), "test.gltf: bufferView 0: 37 bytes at 0 do not fit in buffer 0 (36 bytes)");
    view.document["bufferViews"][0]["byteOffset"] = 9007199254740992;
    EXPECT_EQ(refusal(view),
              "test.gltf: bufferView 0: 37 bytes at 9007199254740992 do not fit in buffer 0 (36 bytes)");
    GltfBuilder stride = triangle();
    stride.document["bufferViews"][0]["byteStride"] = 8;
    EXPECT_EQ(refusal(stride),
              "test.gltf: accessor 0: elements of 12 bytes overlap in bufferView 0 (byteStride 8)");
    stride.document["bufferViews"][0]["byteStride"] = 16;
    EXPECT_EQ(refusal(stride),
              "test.gltf: accessor 0: 3 elements of 12 bytes do not fit in bufferView 0 (36 bytes)");
}

TEST(GltfAccessor, AHugeCountIsRefusedAtOnce)
{
    GltfBuilder builder = triangle();
    builder.document["accessors"][0]["count"] = 100000000;
    EXPECT_EQ(refusal(builder),
              "test.gltf: accessor 0: 100000000 elements of 12 bytes do not fit in bufferView 0 (36 bytes)");
    builder.document["accessors"][0].erase("bufferView");
    EXPECT_EQ(refusal(builder),
              "test.gltf: accessor 0: 100000000 elements without a bufferView, at most 1000000 are read");
}

TEST(GltfAccessor, SharingMustStayWithinReason)
{
    // A thousand primitives of one and the same million vertices.
    GltfBuilder builder;
    builder.document["accessors"] = {{{"componentType", f32}, {"count", 1000000}, {"type", "VEC3"}}};
    json primitives = json::array();
    for (int i = 0; i < 1000; ++i)
        primitives.push_back({{"attributes", {{"POSITION", 0}}}});
    builder.document["meshes"] = {{{"primitives", primitives}}};
    builder.add_node({{"mesh", 0}});
    EXPECT_EQ(refusal(builder), "test.gltf: its meshes read more than 2000000 elements out of 0 bytes");
}

} // namespace
} // namespace lambent::scene::test
