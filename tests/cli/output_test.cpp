// No command writes over a file that it reads, by whatever name it is called.
#include "tests/cli/lambent.h"
#include "tests/scene/gltf_builder.h"

#include "image/files/image_io.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>

namespace lambent {
namespace {

using testing::Folder;
using testing::Outcome;

std::string bytes_of(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string write_panorama(const Folder& folder, const std::string& name)
{
    image::write_radiance({16, 8, 3, std::vector<float>(384, 1.0f)}, folder.path(name));
    return folder.path(name);
}

std::string write_picture(const Folder& folder, const std::string& name, std::uint8_t code)
{
    image::write_codes({8, 8, 3, 8, std::vector<std::uint8_t>(192, code)}, folder.path(name));
    return folder.path(name);
}

// A textured triangle whose image is the file beside it.
void write_model(const Folder& folder, const std::string& texture)
{
    write_picture(folder, texture, 200);
    scene::test::GltfBuilder gltf;
    gltf.add_to("images", {{"uri", texture}});
    gltf.add_to("textures", {{"source", 0}});
    gltf.add_to("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    gltf.add_primitive({{"attributes",
                         {{"POSITION", gltf.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0})},
                          {"TEXCOORD_0", gltf.add_vec2({0, 0, 1, 0, 0, 1})}}},
                        {"material", 0}});
    const scene::test::Bytes file = gltf.gltf();
    write_bytes(folder.path("m.gltf"), std::string(file.begin(), file.end()));
}

// Refused in one line, with every file as it was.
void expect_kept(const Folder& folder, const std::vector<std::string>& words, const std::string& kept)
{
    const std::string before = bytes_of(kept);
    const std::vector<std::string> names = folder.names();
    ASSERT_FALSE(before.empty());
    const Outcome outcome = lambent(words);
    EXPECT_EQ(outcome.code, 2) << words.front() << ": " << outcome.error;
    EXPECT_EQ(outcome.error.rfind("lambent: error: ", 0), 0u) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_TRUE(bytes_of(kept) == before) << kept;
    EXPECT_EQ(folder.names(), names);
}

TEST(Output, APanoramaIsNotReplacedByItsPicture)
{
    const Folder folder;
    const std::string panorama = write_panorama(folder, "in.exr");
    for (const char* command : {"render", "reference"})
        expect_kept(folder, {command, "plane", "--env", panorama, "-o", panorama, "--size", "8x8"}, panorama);
}

TEST(Output, OtherNamesOfTheSameFileAreFound)
{
    const Folder folder;
    const std::string panorama = write_panorama(folder, "in.exr");
    std::filesystem::create_directory(folder.path("deep"));
    std::filesystem::create_symlink(panorama, folder.path("link.exr"));
    std::filesystem::create_hard_link(panorama, folder.path("second.exr"));
    for (const char* name : {"deep/../in.exr", "link.exr", "second.exr"})
        expect_kept(folder, {"render", "plane", "--env", panorama, "-o", folder.path(name), "--size", "8x8"},
                    panorama);
    expect_kept(folder,
                {"render", "plane", "--env", folder.path("link.exr"), "-o", panorama, "--size", "8x8"},
                panorama);
}

TEST(Output, ATextureBesideAModelIsNotReplaced)
{
    const Folder folder;
    write_model(folder, "p.png");
    for (const char* command : {"render", "reference"})
        expect_kept(
            folder,
            {command, folder.path("m.gltf"), "--env", "none", "-o", folder.path("p.png"), "--size", "8x8"},
            folder.path("p.png"));
}

TEST(Output, AVarianceIsNeitherAnInputNorThePicture)
{
    const Folder folder;
    const std::string panorama = write_panorama(folder, "in.exr");
    const std::vector<std::string> words = {"reference", "plane", "--env", panorama, "--size",
                                            "8x8",       "--spp", "1",     "-o",     folder.path("o.exr"),
                                            "--variance"};
    for (const std::string& variance : {panorama, folder.path("o.exr"), folder.path("./o.exr")}) {
        std::vector<std::string> all = words;
        all.push_back(variance);
        expect_kept(folder, all, panorama);
    }
}

TEST(Output, ALayerIsNeitherAnInputNorThePicture)
{
    const Folder folder;
    const std::string panorama = write_panorama(folder, "depth.exr");
    expect_kept(folder,
                {"render", "plane", "--env", panorama, "-o", folder.path("o.png"), "--size", "8x8",
                 "--layers", folder.path("")},
                panorama);
    const Outcome outcome = lambent({"render", "plane", "--env", "none", "-o", folder.path("normal.png"),
                                     "--size", "8x8", "--layers", folder.path("")});
    EXPECT_EQ(outcome.code, 2) << outcome.error;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"depth.exr"});
}

TEST(Output, AHeatMapReplacesNoPicture)
{
    const Folder folder;
    const std::string a = write_picture(folder, "a.png", 10), b = write_picture(folder, "b.png", 20);
    expect_kept(folder, {"compare", a, b, "-o", a}, a);
    expect_kept(folder, {"compare", a, b, "-o", b}, b);
}

TEST(Output, ABakeReplacesNoPanorama)
{
    const Folder folder;
    const std::string panorama = write_panorama(folder, "in.exr");
    std::filesystem::rename(panorama, folder.path("in.ktx2")); // told apart by content
    expect_kept(folder, {"bake", folder.path("in.ktx2"), "-o", folder.path("in.ktx2"), "--size", "8"},
                folder.path("in.ktx2"));
    write_panorama(folder, "split_sum.exr");
    expect_kept(
        folder,
        {"bake", folder.path("split_sum.exr"), "-o", folder.path(""), "--size", "8", "--format", "exr"},
        folder.path("split_sum.exr"));
}

TEST(Output, TheSameCommandTwiceStillReplacesItsOwnPicture)
{
    const Folder folder;
    const std::string panorama = write_panorama(folder, "in.exr");
    for (int i = 0; i < 2; ++i)
        EXPECT_EQ(
            lambent({"render", "plane", "--env", panorama, "-o", folder.path("o.exr"), "--size", "8x8"}).code,
            0);
}

} // namespace
} // namespace lambent
