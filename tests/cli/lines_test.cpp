// Points, lines, instances and hidden nodes as their users meet them: in pictures, references and `info`.
#include "tests/cli/lambent.h"
#include "tests/scene/gltf_builder.h"

#include "image/files/image_io.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

namespace lambent {
namespace {

using nlohmann::json;
using testing::Folder;
using testing::Outcome;

// A camera that looks along -Z, and sees two metres.
void write_model(const Folder& folder, scene::test::GltfBuilder builder)
{
    builder.add_to("cameras", {{"type", "orthographic"},
                               {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 10}}}});
    builder.add_node({{"camera", 0}, {"name", "front"}, {"translation", {0, 0, 5}}});
    const auto bytes = builder.glb();
    write_bytes(folder.path("m.glb"), std::string(bytes.begin(), bytes.end()));
}

image::RadianceImage picture(const Folder& folder, const std::string& command,
                             const std::vector<std::string>& more)
{
    std::vector<std::string> words = {command, folder.path("m.glb"), "--env", "none",   "--camera-node",
                                      "front", "--background",       "none",  "--size", "40x40",
                                      "-o",    folder.path("x.exr")};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = lambent(words);
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    return image::read_radiance(folder.path("x.exr"));
}

double sum(const image::RadianceImage& image, std::size_t channel)
{
    double sum = 0.0;
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = channel; i < image.values.size(); i += channels)
        sum += static_cast<double>(image.values[i]);
    return sum;
}

// A cross of two lines, one metre long each, and two points: 20 pixels and 20, and one each.
TEST(Lines, AreInPicturesReferencesAndInfo)
{
    const Folder folder;
    scene::test::GltfBuilder builder;
    builder.add_to("materials", {{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0.5, 0, 1}}}}});
    builder.add_primitive(
        {{"attributes",
          {{"POSITION", builder.add_vec3({-0.5, 0.51f, 0, 0.5, 0.51f, 0, 0.01f, -0.5, 0, 0.01f, 0.5, 0})}}},
         {"mode", 1},
         {"material", 0}});
    builder.add_primitive(
        {{"attributes", {{"POSITION", builder.add_vec3({0.8f, 0.7f, 0, -0.73f, 0.61f, 0})}}},
         {"mode", 0},
         {"material", 0}});
    write_model(folder, builder);
    for (const auto& [command, more] :
         {std::pair<std::string, std::vector<std::string>>("render", {"--aa", "16"}),
          {"reference", {"--spp", "64"}}}) {
        const image::RadianceImage found = picture(folder, command, more);
        EXPECT_NEAR(sum(found, 0), 42.0, 1.0) << command;
        EXPECT_NEAR(sum(found, 1), 0.5 * sum(found, 0), 0.01) << command;
        EXPECT_EQ(sum(found, 2), 0.0) << command;
    }
    const json info = json::parse(lambent({"info", folder.path("m.glb"), "--json"}).output);
    EXPECT_EQ(info["lines"], 2);
    EXPECT_EQ(info["points"], 2);
    EXPECT_EQ(info["meshes"], 2);
    EXPECT_EQ(info["triangles"], 8);
    // A scene of nothing else is framed.
    const Outcome framed = lambent({"render", folder.path("m.glb"), "--env", "none", "--background", "none",
                                    "--size", "80x80", "-o", folder.path("f.exr")});
    ASSERT_EQ(framed.code, 0) << framed.error;
    EXPECT_GT(sum(image::read_radiance(folder.path("f.exr")), 0), 60.0);
}

// Two instances of a hidden node's mesh, and one that is shown twice.
TEST(Lines, InstancesAndHiddenNodesAreRequiredAndKnown)
{
    const Folder folder;
    scene::test::GltfBuilder builder = scene::test::triangle();
    builder.document["materials"] =
        json::array({{{"extensions", {{"KHR_materials_unlit", json::object()}}}}});
    builder.document["meshes"][0]["primitives"][0]["material"] = 0;
    json& nodes = builder.document["nodes"];
    const json places = {{"attributes", {{"TRANSLATION", builder.add_vec3({-1, 0, 0, 0, -1, 0})}}}};
    nodes[0]["extensions"]["EXT_mesh_gpu_instancing"] = places;
    builder.add_node({{"mesh", 0}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}});
    builder.document["extensionsUsed"] = builder.document["extensionsRequired"] = {
        "EXT_mesh_gpu_instancing", "KHR_node_visibility", "KHR_materials_unlit"};
    write_model(folder, builder);
    // Two triangles of half a square metre, of four.
    for (const char* command : {"render", "reference"}) {
        const image::RadianceImage found =
            picture(folder, command,
                    command == std::string("render") ? std::vector<std::string>{}
                                                     : std::vector<std::string>{"--spp", "16"});
        EXPECT_NEAR(sum(found, 0), 0.25 * 1600.0, 20.0) << command;
        EXPECT_EQ(found.pixel(25, 15)[0], 0.0f) << command; // where the hidden node's would be
    }
    EXPECT_EQ(json::parse(lambent({"info", folder.path("m.glb"), "--json"}).output)["instances"], 2);
}

} // namespace
} // namespace lambent
