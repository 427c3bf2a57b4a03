// Data URIs and files beside the glTF.
#include "scene/gltf.h"
#include "scene/gltf_uri.h"
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

std::string path_refusal(const std::string& uri)
{
    try {
        relative_path(uri, "here");
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(GltfUri, RelativePathsAreDecoded)
{
    EXPECT_EQ(relative_path("a.bin", "here"), "a.bin");
    EXPECT_EQ(relative_path("a%20b%2B+c.bin", "here"), "a b++c.bin");
    EXPECT_EQ(relative_path("textures\\wood%5Coak.png", "here"), "textures/wood/oak.png");
    EXPECT_EQ(relative_path("100%.png", "here"), "100%.png");
    EXPECT_EQ(relative_path("%zz.png", "here"), "%zz.png");
    EXPECT_EQ(relative_path("a/../b.png", "here"), "a/../b.png");
    EXPECT_EQ(relative_path("./a.png", "here"), "./a.png");
    EXPECT_EQ(relative_path("%C3%A9.png", "here"), "\xC3\xA9.png");
}

TEST(GltfUri, PathsThatLeaveTheFolderAreRefused)
{
    EXPECT_EQ(path_refusal("../a.png"), "here: \"../a.png\" leaves the folder of the glTF");
    EXPECT_EQ(path_refusal("a/../../b.png"), "here: \"a/../../b.png\" leaves the folder of the glTF");
    EXPECT_EQ(path_refusal("%2e%2e/a.png"), "here: \"../a.png\" leaves the folder of the glTF");
    EXPECT_EQ(path_refusal("..\\a.png"), "here: \"../a.png\" leaves the folder of the glTF");
    EXPECT_EQ(path_refusal("/etc/passwd"),
              "here: \"/etc/passwd\" is an absolute path; only files beside the glTF are read");
    EXPECT_EQ(path_refusal("%2Fetc/passwd"),
              "here: \"/etc/passwd\" is an absolute path; only files beside the glTF are read");
    EXPECT_EQ(path_refusal("file:///a.png"), "here: \"file:///a.png\" is not a relative path");
    EXPECT_EQ(path_refusal("https://example.org/a.png"),
              "here: \"https://example.org/a.png\" is not a relative path");
    EXPECT_EQ(path_refusal("C:/a.png"), "here: \"C:/a.png\" is not a relative path");
    EXPECT_EQ(path_refusal(""), "here: the uri is not a file name");
    EXPECT_EQ(path_refusal("a%00b"), "here: the uri is not a file name");
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

TEST_F(GltfFiles, FilesOutsideTheFolderStayUnread)
{
    GltfBuilder builder = triangle();
    write_file(folder_ / "secret.bin", builder.binary);
    builder.document["buffers"] = {{{"byteLength", 36}, {"uri", "../secret.bin"}}};
    write_file(folder_ / "inside" / "scene.gltf", builder.gltf());
    Warnings warnings;
    EXPECT_THROW(load_gltf(folder_ / "inside" / "scene.gltf", warnings), Error);
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
    EXPECT_EQ(refusal(builder.gltf()), "test.gltf: buffer 0: \"a.bin\" is outside the file");
}

} // namespace
} // namespace lambent::scene::test
