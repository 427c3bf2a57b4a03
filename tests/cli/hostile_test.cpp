// Files made to break programs: each is refused in one line, with code 3, at once, in little memory, and no output
// file is left.
#include "tests/cli/lambent.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <functional>

namespace lambent {
namespace {

using testing::Folder;
using testing::Outcome;

// A 64x32 Radiance file of run-length coded rows.
std::string good_hdr()
{
    std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n";
    for (int y = 0; y < 32; ++y) {
        hdr += std::string("\x02\x02\x00\x40", 4);
        for (int channel = 0; channel < 4; ++channel)
            hdr += std::string("\xc0\x80", 2); // 64 times 0x80
    }
    return hdr;
}

std::string hdr_of_size(const std::string& size)
{
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + size + "\n" + std::string(200, '\x80');
}

std::string overlong_runs()
{
    std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 64\n";
    for (int y = 0; y < 4; ++y)
        hdr += std::string("\x02\x02\x00\x40\xff\x80\xff\x80\xff\x80", 10); // runs of 127 in a row of 64
    return hdr;
}

std::string little_endian(std::uint32_t value)
{
    std::string bytes(4, '\0');
    std::memcpy(bytes.data(), &value, 4);
    return bytes;
}

std::string glb(std::string json, std::string binary = "")
{
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    std::string body = little_endian(static_cast<std::uint32_t>(json.size())) + "JSON" + json;
    if (!binary.empty())
        body += little_endian(static_cast<std::uint32_t>(binary.size())) + std::string("BIN\0", 4) + binary;
    return "glTF" + little_endian(2) + little_endian(static_cast<std::uint32_t>(12 + body.size())) + body;
}

// One triangle; `part` replaces a piece of the JSON.
std::string triangle(const std::string& from = "", const std::string& to = "")
{
    std::string json =
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
        R"("buffers":[{"byteLength":42}],"bufferViews":[{"buffer":0,"byteLength":36},)"
        R"({"buffer":0,"byteOffset":36,"byteLength":6}],)"
        R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",)"
        R"("min":[0,0,0],"max":[1,1,0]},{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}]})";
    if (!from.empty())
        json.replace(json.find(from), from.size(), to);
    const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::uint16_t indices[3] = {0, 1, 2};
    std::string binary(42, '\0');
    std::memcpy(binary.data(), corners, 36);
    std::memcpy(binary.data() + 36, indices, 6);
    return glb(json, binary);
}

struct Case {
    const char* name;
    std::string bytes;
};

// How a file is used: as the scene, as the environment, as what is baked into a file or into a folder.
enum class Use { scene, environment, bake_file, bake_folder };

std::vector<std::string> command_for(Use use, const Folder& folder, const std::string& file)
{
    const std::string picture = folder.path("out.png");
    switch (use) {
    case Use::scene:
        return {"render", file, "-o", picture, "--size", "32x18"};
    case Use::environment:
        return {"render", "sphere", "--env", file, "-o", picture, "--size", "32x18"};
    case Use::bake_file:
        return {"bake", file, "-o", folder.path("out.ktx2"), "--size", "8"};
    case Use::bake_folder:
        break;
    }
    return {"bake", file, "-o", folder.path("out"), "--size", "8"};
}

// Runs the file and checks how it is refused.
void expect_refused(const Case& bad, Use use)
{
    const Folder folder;
    const std::string file = folder.path(use == Use::scene ? "bad.glb" : "bad.hdr");
    write_bytes(file, bad.bytes);
    const Outcome outcome = lambent(command_for(use, folder, file));
    EXPECT_EQ(outcome.code, 3) << bad.name << ": " << outcome.error;
    EXPECT_EQ(outcome.error.rfind("lambent: error: " + file, 0), 0u) << bad.name << ": " << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1)
        << bad.name << ": " << outcome.error;
    EXPECT_EQ(folder.names().size(), 1u) << bad.name;
#ifndef __SANITIZE_ADDRESS__
    EXPECT_LT(outcome.megabytes, 100.0) << bad.name;
#endif
    EXPECT_LT(outcome.seconds, 10.0 * testing::patience) << bad.name; // a hang, not a speed
}

TEST(Hostile, GoodFilesAreTaken)
{
    const Folder folder;
    write_bytes(folder.path("good.hdr"), good_hdr());
    write_bytes(folder.path("good.glb"), triangle());
    const Outcome outcome = lambent({"render", folder.path("good.glb"), "--env", folder.path("good.hdr"),
                                     "-o", folder.path("x.png"), "--size", "32x18"});
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
}

TEST(Hostile, Panoramas)
{
    const std::string good = good_hdr();
    const std::vector<Case> cases = {
        {"empty", ""},
        {"text", "this is not a picture\n"},
        {"binary", std::string(1000, '\x07')},
        {"header cut", good.substr(0, 20)},
        {"header cut in the size", good.substr(0, 45)},
        {"body cut", good.substr(0, good.size() - 5)},
        {"body cut early", good.substr(0, 80)},
        {"huge", hdr_of_size("-Y 100000 +X 200000")},
        {"huge but allowed width", hdr_of_size("-Y 16384 +X 16384")},
        {"zero", hdr_of_size("-Y 0 +X 64")},
        {"negative", hdr_of_size("-Y -32 +X 64")},
        {"overflowing", hdr_of_size("-Y 4294967297 +X 64")},
        {"one texel", hdr_of_size("-Y 1 +X 1")},
        {"overlong runs", overlong_runs()},
        {"missing size", "#?RADIANCE\n\n"},
        {"a model", triangle()},
    };
    for (const Case& bad : cases)
        for (const Use use : {Use::environment, Use::bake_file, Use::bake_folder})
            expect_refused(bad, use);
}

TEST(Hostile, Models)
{
    std::string wrong_magic = triangle();
    wrong_magic[0] = 'X';
    std::string long_chunk = triangle();
    long_chunk.replace(12, 4, little_endian(0x7fffffff));
    std::string deep = R"({"asset":{"version":"2.0"},"nodes":)";
    deep += std::string(100000, '[') + std::string(100000, ']') + "}";
    const std::vector<Case> cases = {
        {"empty", ""},
        {"text", "hello"},
        {"bad magic", wrong_magic},
        {"short header", triangle().substr(0, 11)},
        {"short chunk", triangle().substr(0, 30)},
        {"cut binary", triangle().substr(0, triangle().size() - 4)},
        {"chunk past the end", long_chunk},
        {"not JSON", glb("{nonsense")},
        {"no asset", glb("{}")},
        {"version 1", glb(R"({"asset":{"version":"1.0"}})")},
        {"accessor past the buffer",
         triangle("\"count\":3,\"type\":\"VEC3\"", "\"count\":4,\"type\":\"VEC3\"")},
        {"a hundred million",
         triangle("\"count\":3,\"type\":\"VEC3\"", "\"count\":100000000,\"type\":\"VEC3\"")},
        {"negative count", triangle("\"count\":3,\"type\":\"VEC3\"", "\"count\":-3,\"type\":\"VEC3\"")},
        {"view past the buffer", triangle("\"byteOffset\":36", "\"byteOffset\":4000000000")},
        {"missing accessor", triangle("\"POSITION\":0", "\"POSITION\":7")},
        {"missing mesh", triangle("\"mesh\":0", "\"mesh\":5")},
        {"negative mesh", triangle("\"mesh\":0", "\"mesh\":-7")},
        {"missing node", triangle("\"nodes\":[0]}", "\"nodes\":[9]}")},
        {"required extension",
         triangle("\"scene\":0,", "\"scene\":0,\"extensionsRequired\":[\"KHR_unheard_of\"],")},
        {"deep nesting", deep},
    };
    for (const Case& bad : cases)
        expect_refused(bad, Use::scene);
}

TEST(Hostile, IndicesPastTheVertices)
{
    std::string bytes = triangle();
    // The last index lies two bytes before the padding of the binary chunk.
    bytes[bytes.size() - 4] = '\x07';
    expect_refused({"index past the vertices", bytes}, Use::scene);
}

TEST(Hostile, FilesThatAreNone)
{
    const Folder folder;
    const std::string out = folder.path("x.png");
    for (const std::string& path : {folder.path("missing.glb"), folder.path(""), std::string("/dev/zero")}) {
        EXPECT_EQ(lambent({"render", path, "-o", out}).code, 3) << path;
        EXPECT_EQ(lambent({"render", "sphere", "--env", path, "-o", out}).code, 3) << path;
        EXPECT_EQ(lambent({"bake", path, "-o", folder.path("x")}).code, 3) << path;
        EXPECT_EQ(lambent({"info", path}).code, 3) << path;
    }
    EXPECT_TRUE(folder.names().empty());
}

TEST(Hostile, TinyPanoramasWork)
{
    const Folder folder;
    write_bytes(folder.path("tiny.hdr"),
                "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n" + std::string(8, '\x80'));
    const Outcome outcome = lambent({"render", "sphere", "--env", folder.path("tiny.hdr"), "-o",
                                     folder.path("x.png"), "--size", "32x18"});
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    const Outcome baked = lambent({"bake", folder.path("tiny.hdr"), "-o", folder.path("x"), "--size", "8"});
    EXPECT_EQ(baked.code, 0) << baked.error;
    EXPECT_EQ(baked.error, "");
}

} // namespace
} // namespace lambent
