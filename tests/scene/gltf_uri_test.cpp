// Data URIs and files beside the glTF.
#include "scene/gltf/gltf.h"
#include "scene/gltf_document/gltf_uri.h"
#include "tests/scene/gltf_builder.h"

#include "base/file.h"

#include <gtest/gtest.h>

#include <filesystem>

#include <unistd.h>

namespace lambent::scene::test {
namespace {

namespace fs = std::filesystem;

// A folder of this test alone, gone afterwards.
class GltfFiles : public testing::Test {
protected:
    void SetUp() override
    {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() /
                  ("lambent_gltf_" + std::string(info->name()) + "_" + std::to_string(::getpid()));
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "inside" / "deeper");
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path folder_;
};

const UriBase beside{fs::path("/models/fish"), {}};

std::string path_refusal(const std::string& uri)
{
    try {
        path_beside(beside, uri, "here");
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

fs::path path_of(const std::string& uri, const Reach& reach = {})
{
    return path_beside({fs::path("/models/fish"), reach}, uri, "here");
}

TEST(GltfUri, RelativePathsAreDecoded)
{
    EXPECT_EQ(path_of("a.bin"), "/models/fish/a.bin");
    EXPECT_EQ(path_of("a%20b%2B+c.bin"), "/models/fish/a b++c.bin");
    EXPECT_EQ(path_of("textures\\wood%5Coak.png"), "/models/fish/textures/wood/oak.png");
    EXPECT_EQ(path_of("100%.png"), "/models/fish/100%.png");
    EXPECT_EQ(path_of("%zz.png"), "/models/fish/%zz.png");
    EXPECT_EQ(path_of("a/../b.png"), "/models/fish/b.png");
    EXPECT_EQ(path_of("./a.png"), "/models/fish/a.png");
    EXPECT_EQ(path_of("%C3%A9.png"), "/models/fish/\xC3\xA9.png");
    EXPECT_EQ(path_of("../fish/a.png"), "/models/fish/../fish/a.png") << "it comes back";
}

TEST(GltfUri, PathsThatLeaveTheFolderAreRefused)
{
    EXPECT_EQ(path_refusal("../a.png"), "here: \"../a.png\" leaves the folder of the glTF");
    EXPECT_EQ(path_refusal("../fishes/a.png"), "here: \"../fishes/a.png\" leaves the folder of the glTF");
    EXPECT_EQ(path_refusal("a/../../b.png"), "here: \"a/../../b.png\" leaves the folder of the glTF");
    EXPECT_EQ(path_refusal("%2e%2e/a.png"), "here: \"../a.png\" leaves the folder of the glTF");
    EXPECT_EQ(path_refusal("..\\a.png"), "here: \"../a.png\" leaves the folder of the glTF");
    EXPECT_EQ(path_refusal("/etc/passwd"),
              "here: \"/etc/passwd\" is an absolute path; only relative ones are read");
    EXPECT_EQ(path_refusal("%2Fetc/passwd"),
              "here: \"/etc/passwd\" is an absolute path; only relative ones are read");
    EXPECT_EQ(path_refusal("file:///a.png"), "here: \"file:///a.png\" is not a relative path");
    EXPECT_EQ(path_refusal("https://example.org/a.png"),
              "here: \"https://example.org/a.png\" is not a relative path");
    EXPECT_EQ(path_refusal("C:/a.png"), "here: \"C:/a.png\" is not a relative path");
    EXPECT_EQ(path_refusal(""), "here: the uri is not a file name");
    EXPECT_EQ(path_refusal("a%00b"), "here: the uri is not a file name");
}

TEST(GltfUri, TheReachSaysHowFarTheyMayLead)
{
    EXPECT_EQ(path_of("../../tex/a.png", {true, {}}), "/models/fish/../../tex/a.png");
    EXPECT_EQ(path_of("../tex/a.png", {false, {"/models"}}), "/models/fish/../tex/a.png");
    EXPECT_EQ(path_of("../tex/a.png", {false, {"/other", "/models/tex/"}}), "/models/fish/../tex/a.png");
    EXPECT_THROW(path_of("../../models2/a.png", {false, {"/models"}}), Error);
    EXPECT_THROW(path_of("a.png", {false, {"/models/tex"}}), Error);
    EXPECT_THROW(path_of("/etc/passwd", {true, {}}), Error);
    EXPECT_THROW(path_of("file:///etc/passwd", {true, {}}), Error);
}

TEST(GltfUri, Base64IsDecodedStrictly)
{
    EXPECT_EQ(decode_data_uri("data:;base64,", "here"), Bytes{});
    EXPECT_EQ(decode_data_uri("data:;base64,Zg==", "here"), to_bytes("f")); // RFC 4648, section 10
    EXPECT_EQ(decode_data_uri("data:image/png;base64,Zm8=", "here"), to_bytes("fo"));
    EXPECT_EQ(decode_data_uri("data:x/y;name=z;base64,Zm9vYmE", "here"), to_bytes("fooba"));
    EXPECT_EQ(decode_data_uri("data:;base64,+/+/", "here"), (Bytes{0xFB, 0xFF, 0xBF}));
    EXPECT_THROW(decode_data_uri("data:text/plain,foo", "here"), Error);
    EXPECT_THROW(decode_data_uri("data:;base64", "here"), Error);
    EXPECT_THROW(decode_data_uri("data:;base64,Zm9*", "here"), Error);
    EXPECT_THROW(decode_data_uri("data:;base64,Zm=v", "here"), Error);
    EXPECT_THROW(decode_data_uri("data:;base64,Zm9vY", "here"), Error);
}

TEST_F(GltfFiles, ABufferBesideTheFileIsFound)
{
    GltfBuilder builder = triangle();
    write_file(folder_ / "inside" / "my data.bin", builder.binary);
    builder.document["buffers"] = {{{"byteLength", 36}, {"uri", "inside/my%20data.bin"}}};
    write_file(folder_ / "scene.gltf", builder.gltf());
    Warnings warnings;
    EXPECT_EQ(load_gltf(folder_ / "scene.gltf", warnings).meshes[0].positions[2], glm::vec3(0, 1, 0));
    EXPECT_TRUE(warnings.empty());
}

TEST_F(GltfFiles, AMissingFileIsNamed)
{
    GltfBuilder builder = triangle();
    builder.document["buffers"] = {{{"byteLength", 36}, {"uri", "missing.bin"}}};
    write_file(folder_ / "scene.gltf", builder.gltf());
    Warnings warnings;
    try {
        load_gltf(folder_ / "scene.gltf", warnings);
        FAIL() << "a missing file was read";
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::bad_input);
        EXPECT_TRUE(contains(error.what(), "scene.gltf: buffer 0: "));
        EXPECT_TRUE(contains(error.what(), "missing.bin: No such file"));
    }
}

TEST_F(GltfFiles, FilesOutsideTheFolderAreReadWithinReachAlone)
{
    GltfBuilder builder = triangle();
    write_file(folder_ / "secret.bin", builder.binary);
    builder.document["buffers"] = {{{"byteLength", 36}, {"uri", "../secret.bin"}}};
    const fs::path scene = folder_ / "inside" / "scene.gltf";
    write_file(scene, builder.gltf());
    Warnings warnings;
    EXPECT_THROW(load_gltf(scene, warnings), Error);
    EXPECT_THROW(load_gltf(scene, warnings, {false, {folder_ / "inside"}}), Error);
    EXPECT_TRUE(GltfFile(scene, warnings).files().empty()) << "not watched either";
    warnings.clear();
    EXPECT_EQ(load_gltf(scene, warnings, {false, {folder_}}).meshes.size(), 1u);
    EXPECT_EQ(load_gltf(scene, warnings, {true, {}}).meshes.size(), 1u);
    EXPECT_TRUE(warnings.empty());
}

TEST_F(GltfFiles, LinksDoNotLeadOutOfReach)
{
    GltfBuilder builder = triangle();
    write_file(folder_ / "secret.bin", builder.binary);
    fs::create_symlink(folder_ / "secret.bin", folder_ / "inside" / "link.bin");
    fs::create_directory_symlink(folder_, folder_ / "inside" / "up");
    for (const char* uri : {"link.bin", "up/secret.bin"}) {
        builder.document["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
        const fs::path scene = folder_ / "inside" / "scene.gltf";
        write_file(scene, builder.gltf());
        Warnings warnings;
        try {
            load_gltf(scene, warnings);
            ADD_FAILURE() << uri;
        } catch (const Error& error) {
            EXPECT_TRUE(contains(error.what(), "is a link that leads out of the folder")) << error.what();
        }
        EXPECT_EQ(load_gltf(scene, warnings, {false, {folder_}}).meshes.size(), 1u);
        EXPECT_EQ(load_gltf(scene, warnings, {true, {}}).meshes.size(), 1u);
    }
}

TEST_F(GltfFiles, AFolderOrAMissingSceneIsRefused)
{
    Warnings warnings;
    EXPECT_THROW(load_gltf(folder_, warnings), Error);
    EXPECT_THROW(load_gltf(folder_ / "none.glb", warnings), Error);
}

TEST(GltfUri, BytesInMemoryHaveNoFilesBesideThem)
{
    GltfBuilder builder = triangle();
    builder.document["buffers"] = {{{"byteLength", 36}, {"uri", "a.bin"}}};
    EXPECT_EQ(refusal(builder.gltf()),
              "test.gltf: buffer 0: \"a.bin\" is an external file; only embedded data is read");
}

} // namespace
} // namespace lambent::scene::test
