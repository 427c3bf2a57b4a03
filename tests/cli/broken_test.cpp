// Files with broken parts, as users meet them: drawn with one warning line, or with --strict refused.
#include "tests/cli/lambent.h"
#include "tests/scene/gltf_builder.h"

#include "image/files/image_io.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace lambent {
namespace {

using scene::test::GltfBuilder;
using scene::test::json;
using testing::Folder;
using testing::Outcome;

// A square that fills the picture of its camera, unlit, its base colour an image of this uri.
GltfBuilder textured(const std::string& uri)
{
    GltfBuilder b;
    const int positions = b.add_vec3({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0});
    const int texcoords = b.add_vec2({0, 1, 1, 1, 1, 0, 0, 0});
    b.document["extensionsUsed"] = {"KHR_materials_unlit"};
    b.document["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                                {"extensions", {{"KHR_materials_unlit", json::object()}}}}};
    b.document["textures"] = {{{"source", 0}}};
    b.document["images"] = {{{"uri", uri}}};
    b.add_primitive({{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", texcoords}}},
                     {"indices", b.add_indices({0, 1, 2, 0, 2, 3})},
                     {"material", 0}});
    b.document["cameras"] = {{{"type", "orthographic"},
                              {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 10}}}}};
    b.add_node({{"name", "cam"}, {"camera", 0}, {"translation", {0, 0, 5}}});
    return b;
}

void write_model(const std::string& path, const GltfBuilder& builder)
{
    const auto bytes = builder.gltf();
    write_bytes(path, std::string(bytes.begin(), bytes.end()));
}

Outcome draw(const std::string& command, const std::string& file, const std::string& out,
             const std::vector<std::string>& more = {})
{
    std::vector<std::string> words = {command,  file,  "--camera-node", "cam",  "--env", "none",
                                      "--size", "8x8", "--background",  "none", "-o",    out};
    if (command == "reference")
        words.insert(words.end(), {"--spp", "1"});
    words.insert(words.end(), more.begin(), more.end());
    return lambent(words);
}

// The radiance in the middle of a picture, which has alpha.
std::vector<float> middle(const std::string& path)
{
    const image::RadianceImage picture = image::read_radiance(path);
    const float* pixel = picture.pixel(picture.width / 2, picture.height / 2);
    return {pixel[0], pixel[1], pixel[2]};
}

void write_red(const std::string& path)
{
    image::CodeImage red{4, 4, 3, 8, {}};
    for (int i = 0; i < 16; ++i)
        red.bytes.insert(red.bytes.end(), {255, 0, 0});
    image::write_codes(red, path);
}

TEST(Broken, AMissingTextureCostsTheTexture)
{
    const Folder folder;
    const std::string file = folder.path("m.gltf"), out = folder.path("x.exr");
    write_model(file, textured("missing.png"));
    for (const char* command : {"render", "reference"}) {
        const Outcome outcome = draw(command, file, out);
        EXPECT_EQ(outcome.code, 0) << outcome.error;
        EXPECT_EQ(outcome.error.rfind("lambent: warning: " + file + ": image 0: ", 0), 0u) << outcome.error;
        EXPECT_NE(outcome.error.find("missing.png: No such file"), std::string::npos) << outcome.error;
        EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
        for (const float channel : middle(out))
            EXPECT_NEAR(channel, 1.0f, 1e-3f) << command; // the factor alone
        std::filesystem::remove(out);
    }
}

TEST(Broken, StrictMakesWarningsOfInputsErrors)
{
    const Folder folder;
    const std::string model = folder.path("m.gltf"), whole = folder.path("w.gltf"),
                      nan = folder.path("nan.exr"), out = folder.path("x.exr");
    write_red(folder.path("red.png"));
    write_model(model, textured("missing.png"));
    write_model(whole, textured("red.png"));
    image::RadianceImage light{8, 4, 3, std::vector<float>(8 * 4 * 3, 1.0f)};
    light.values[40] = std::numeric_limits<float>::quiet_NaN();
    image::write_radiance(light, nan);
    const std::size_t files = folder.names().size();
    const auto expect_strict = [&](std::vector<std::string> words, const std::string& file) {
        words.emplace_back("--strict");
        const Outcome outcome = lambent(words);
        EXPECT_EQ(outcome.code, 3) << words[0] << ": " << outcome.error;
        EXPECT_EQ(outcome.error.rfind("lambent: error: " + file, 0), 0u) << outcome.error;
        EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
        EXPECT_EQ(folder.names().size(), files) << words[0];
    };
    const std::string size = "8x8";
    expect_strict({"render", model, "--env", "none", "--size", size, "-o", out}, model);
    expect_strict({"render", model, "--env", "none", "--size", size, "-o", out, "--quiet"}, model);
    expect_strict({"reference", model, "--env", "none", "--size", size, "--spp", "1", "-o", out}, model);
    expect_strict({"info", model}, model);
    expect_strict({"serve", model, "--env", "none", "--port", "0"}, model);
    expect_strict({"render", whole, "--env", nan, "--size", size, "-o", out}, nan);
    expect_strict({"reference", whole, "--env", nan, "--size", size, "--spp", "1", "-o", out}, nan);
    expect_strict({"bake", nan, "--size", "8", "-o", folder.path("x.ktx2")}, nan);
    expect_strict({"compare", nan, nan}, nan);
    const Outcome fine = draw("render", whole, out, {"--strict"});
    EXPECT_EQ(fine.code, 0) << fine.error;
    EXPECT_EQ(fine.error, "");
}

TEST(Broken, ReferencesOutOfTheFolderAreFollowedByTheCommand)
{
    const Folder folder;
    std::filesystem::create_directories(folder.path("model"));
    std::filesystem::create_directories(folder.path("tex"));
    write_red(folder.path("tex/p.png"));
    write_model(folder.path("model/m.gltf"), textured("../tex/p.png"));
    const std::string out = folder.path("x.exr");
    for (const char* command : {"render", "reference"}) {
        const Outcome outcome = draw(command, folder.path("model/m.gltf"), out);
        EXPECT_EQ(outcome.code, 0) << outcome.error;
        EXPECT_EQ(outcome.error, "");
        EXPECT_EQ(middle(out), (std::vector<float>{1, 0, 0})) << command;
    }
    // `serve` reads nothing outside of its folders.
    const Outcome served =
        lambent({"serve", folder.path("model/m.gltf"), "--env", "none", "--port", "0", "--strict"});
    EXPECT_EQ(served.code, 3);
    EXPECT_NE(served.error.find("\"../tex/p.png\" leaves the folders that may be read"), std::string::npos)
        << served.error;
    // Nor does the command read what is named by its place on this machine.
    for (const std::string& uri : {"file://" + folder.path("tex/p.png"), folder.path("tex/p.png")}) {
        write_model(folder.path("model/m.gltf"), textured(uri));
        const Outcome outcome = draw("render", folder.path("model/m.gltf"), out);
        EXPECT_EQ(outcome.code, 0);
        EXPECT_NE(outcome.error.find("the texture is left out"), std::string::npos) << outcome.error;
    }
}

TEST(Broken, ADamagedPictureIsComparedWithAWarning)
{
    const Folder folder;
    const std::string whole = folder.path("a.png"), cut = folder.path("b.png");
    write_red(whole);
    std::filesystem::copy_file(whole, cut);
    std::filesystem::resize_file(cut, std::filesystem::file_size(cut) - 12); // its end mark
    const Outcome outcome = lambent({"compare", cut, whole});
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(outcome.error.rfind("lambent: warning: " + cut + ": not a valid PNG: ", 0), 0u)
        << outcome.error;
    EXPECT_EQ(json::parse(outcome.output).at("rmse"), 0.0);
    EXPECT_EQ(lambent({"compare", cut, whole, "--strict"}).code, 3);
}

TEST(Broken, GltfOneIsNamed)
{
    const Folder folder;
    const std::string file = folder.path("old.gltf");
    for (const char* text : {R"({"asset":{"version":"1.0"},"accessors":{},"nodes":{"n":{"meshes":[]}}})",
                             R"({"nodes":{"n":{"meshes":[]}},"scenes":{}})"}) {
        write_bytes(file, text);
        const Outcome outcome = lambent({"info", file});
        EXPECT_EQ(outcome.code, 3);
        EXPECT_EQ(outcome.error, "lambent: error: " + file + ": glTF 1.0 is not supported, only 2.0\n");
    }
}

TEST(Broken, ACycleOfNodesIsCut)
{
    const Folder folder;
    write_red(folder.path("red.png"));
    GltfBuilder builder = textured("red.png");
    builder.document["nodes"][0]["children"] = {0};
    write_model(folder.path("m.gltf"), builder);
    const Outcome outcome = draw("render", folder.path("m.gltf"), folder.path("x.exr"));
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_NE(outcome.error.find("node 0 is its own ancestor"), std::string::npos) << outcome.error;
    EXPECT_EQ(middle(folder.path("x.exr")), (std::vector<float>{1, 0, 0}));
}

} // namespace
} // namespace lambent
