// Files that leave out what glTF 2.0 lets them leave out, or hold what it lets them hold: read without a word.
#include "tests/scene/gltf_builder.h"
#include "tests/scene/png_writer.h"

#include "scene/gltf/gltf.h"

#include <gtest/gtest.h>

#include <functional>

namespace lambent::scene::test {
namespace {

// A triangle with something more, which loads as a scene of one instance without a warning.
Scene load_with(const std::function<void(GltfBuilder&)>& more)
{
    GltfBuilder builder = triangle();
    more(builder);
    Warnings warnings;
    Scene scene = load(builder, &warnings);
    EXPECT_EQ(warnings, Warnings{});
    EXPECT_EQ(scene.instances.size(), 1u);
    return scene;
}

json& first_primitive(GltfBuilder& builder)
{
    return builder.document["meshes"][0]["primitives"][0];
}

TEST(GltfValid, AccessorsWithoutBufferViewAreZeros)
{
    load_with([](GltfBuilder& b) {
        const int zeros = b.add_to("accessors", {{"componentType", f32}, {"count", 3}, {"type", "VEC4"}});
        first_primitive(b)["attributes"]["COLOR_0"] = zeros;
    });
    // Indices of a sparse part alone.
    const Scene scene = load_with([](GltfBuilder& b) {
        const int at = b.add_view({0, 1, 2}), values = b.add_view({2, 1, 0});
        first_primitive(b)["indices"] =
            b.add_to("accessors", {{"componentType", u8},
                                   {"count", 3},
                                   {"type", "SCALAR"},
                                   {"sparse",
                                    {{"count", 3},
                                     {"indices", {{"bufferView", at}, {"componentType", u8}}},
                                     {"values", {{"bufferView", values}}}}}});
    });
    const Mesh& mesh = scene.meshes.at(0);
    EXPECT_EQ(mesh.positions.at(mesh.triangles.at(0).x), glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.positions.at(mesh.triangles.at(0).z), glm::vec3(0, 0, 0));
}

TEST(GltfValid, ImagesAreToldByTheirBytes)
{
    const Scene scene = load_with([](GltfBuilder& b) {
        b.add_to("images", {{"bufferView", b.add_view(make_png({1, 1, 8, {1, 2, 3, 4}}))}});
        b.add_to("textures", {{"source", 0}});
        b.add_to("materials", {{"emissiveTexture", {{"index", 0}}}});
        first_primitive(b)["material"] = 0;
        first_primitive(b)["attributes"]["TEXCOORD_0"] = b.add_vec2({0, 0, 1, 0, 0, 1});
    });
    EXPECT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.materials.at(0).emissive_texture.sampler.wrap_u, Wrap::repeat);
}

TEST(GltfValid, MaterialsSamplersAndLightsMayBeEmpty)
{
    const Scene scene = load_with([](GltfBuilder& b) {
        b.document["materials"] = {json::object(), {{"pbrMetallicRoughness", json::object()}}};
        b.document["samplers"] = {json::object()};
        b.document["textures"] = {json::object()};
        b.document["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}},
                                                                     {{"type", "directional"}}};
        b.document["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 1;
        first_primitive(b)["material"] = 1;
    });
    EXPECT_EQ(scene.materials.at(0).base_color, glm::vec4(1.0f));
    EXPECT_EQ(scene.materials.at(0).metallic, 1.0f);
    EXPECT_EQ(scene.lights.at(0).intensity, glm::vec3(1.0f));
}

TEST(GltfValid, SkinsMayHaveJointsAlone)
{
    load_with([](GltfBuilder& b) {
        const int joints = b.add<std::uint8_t>("VEC4", u8, std::vector<std::uint8_t>(12, 0));
        const int weights = b.add_vec4({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
        first_primitive(b)["attributes"]["JOINTS_0"] = joints;
        first_primitive(b)["attributes"]["WEIGHTS_0"] = weights;
        b.document["skins"] = {{{"joints", {1}}}};
        b.document["nodes"][0]["skin"] = 0;
        b.add_node({{"name", "joint"}});
    });
}

// What an extension that is not known moves has no node; the other channels play. The one is told of.
TEST(GltfValid, ChannelsMayLackANode)
{
    GltfBuilder b = triangle();
    const int times = b.add("SCALAR", f32, std::vector<float>{0, 1});
    const int places = b.add_vec3({0, 0, 0, 5, 0, 0});
    b.document["animations"] = {
        {{"channels",
          {{{"sampler", 0}, {"target", {{"path", "pointer"}, {"extensions", {{"VENDOR_x", {{"a", {1}}}}}}}}},
           {{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
         {"samplers", {{{"input", times}, {"output", places}}}}}};
    const Bytes bytes = b.glb();
    Warnings warnings;
    const GltfFile file({"test.gltf", bytes, std::nullopt, {}}, warnings);
    EXPECT_EQ(file.pose({0, 1.0}).instances.at(0).transform[3].x, 5.0f);
    EXPECT_EQ(warnings, Warnings{"test.gltf: 1 animation channels of unknown properties: left out"});
}

TEST(GltfValid, ExtrasAndUnknownExtensionsMayBeAnywhere)
{
    load_with([](GltfBuilder& b) {
        const json anything[] = {5, "text", {1, {{"index", "x"}}}, {{"primitives", {{"mode", -1}}}}};
        for (const char* list : {"accessors", "bufferViews", "meshes", "nodes", "scenes"})
            for (const json& extras : anything) {
                b.document[list][0]["extras"] = extras;
                b.document[list][0]["extensions"]["VENDOR_x"] = extras;
            }
        first_primitive(b)["extras"] = {{"indices", -3}};
        first_primitive(b)["extensions"]["VENDOR_x"] = {{"indices", {{{{1}}}}}};
        b.document["asset"]["extras"] = {{"version", 1}};
        b.document["extensions"]["VENDOR_x"] = {{"lights", 1}};
    });
}

// More of each than any limit of a file's size would have let through.
TEST(GltfValid, ListsMayBeLong)
{
    for (const char* list : {"materials", "textures", "images", "cameras", "skins", "scenes"}) {
        const json element = std::string_view(list) == "cameras"
                                 ? json{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}
                             : std::string_view(list) == "images" ? json{{"uri", "a.png"}}
                             : std::string_view(list) == "skins"  ? json{{"joints", {0}}}
                             : std::string_view(list) == "scenes" ? json{{"nodes", {0}}}
                                                                  : json::object();
        load_with([&](GltfBuilder& b) {
            json elements = json::array();
            elements.get_ref<json::array_t&>().assign(30'000, element);
            b.document[list] = std::move(elements);
        });
    }
}

} // namespace
} // namespace lambent::scene::test
