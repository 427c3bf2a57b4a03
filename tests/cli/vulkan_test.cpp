// `--backend vulkan` as its users meet it.
#include "tests/cli/lambent.h"

#include "image/files/image_io.h"
#include "tests/image/cube_reader.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace lambent {
namespace {

using nlohmann::json;
using testing::Folder;
using testing::Outcome;

// Drivers keep some memory to the end of the program, which is no leak of ours.
Outcome drawn(const std::string& output, const std::vector<std::string>& more)
{
    std::vector<std::string> words = {"LSAN_OPTIONS=detect_leaks=0",
                                      LAMBENT_PROGRAM,
                                      "render",
                                      "report",
                                      "-o",
                                      output,
                                      "--size",
                                      "96x54",
                                      "--bounces",
                                      "0"};
    words.insert(words.end(), more.begin(), more.end());
    return testing::run_program("env", words);
}

void expect_refused(const Outcome& outcome, int code)
{
    EXPECT_EQ(outcome.code, code) << outcome.error;
    EXPECT_EQ(outcome.error.rfind("lambent: error: ", 0), 0u) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
}

TEST(Vulkan, DrawsWhatTheProcessorDraws)
{
    const Folder folder;
    const Outcome there = drawn(folder.path("there.png"), {"--backend", "vulkan", "--stats", "json"});
    if (there.code == 4 && !std::getenv("LAMBENT_REQUIRE_VULKAN"))
        GTEST_SKIP() << there.error;
    ASSERT_EQ(there.code, 0) << there.error;
    const json stats = json::parse(there.output);
    EXPECT_EQ(stats["backend"], "vulkan");
    for (const char* pass : {"triangles", "edges", "surfaces", "direct", "ambient", "specular", "resolve"})
        EXPECT_GE(stats["device_ms"].value(pass, -1.0), 0.0) << pass;
    ASSERT_EQ(drawn(folder.path("here.png"), {"--backend", "cpu"}).code, 0);
    const image::CodeImage a = image::read_codes(folder.path("there.png")),
                           b = image::read_codes(folder.path("here.png"));
    ASSERT_EQ(a.bytes.size(), b.bytes.size());
    // Where surfaces end the two may see different ones.
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.bytes.size(); ++i)
        different += std::abs(a.bytes[i] - b.bytes[i]) > 2 ? 1 : 0;
    EXPECT_LE(different, a.bytes.size() / 100);
}

test::CubeFile read_cube(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return test::read_ktx2(test::Bytes(std::istreambuf_iterator<char>(file), {}));
}

// Of a level of all faces, over its mean; and the largest difference over that of the brightest texel.
struct Apart {
    double relative_rmse, largest;
};

Apart apart(const std::array<test::Face, 6>& found, const std::array<test::Face, 6>& wanted)
{
    double squares = 0.0, sum = 0.0, count = 0.0, largest = 0.0, brightest = 0.0;
    for (std::size_t face = 0; face < 6; ++face) {
        EXPECT_EQ(found[face].size(), wanted[face].size());
        for (std::size_t i = 0; i < wanted[face].size(); ++i)
            for (std::size_t c = 0; c < 3; ++c) {
                const double a = found[face].at(i)[c], b = wanted[face][i][c];
                squares += (a - b) * (a - b);
                sum += b, count += 1.0;
                largest = std::max(largest, std::fabs(a - b));
                brightest = std::max(brightest, b);
            }
    }
    EXPECT_GT(sum, 0.0);
    return {std::sqrt(squares / count) / (sum / count), largest / brightest};
}

// As far as both may be off what they are asked for, which is 0.01; usually they are nearer to each other by far.
void expect_alike(const test::CubeFile& found, const test::CubeFile& wanted)
{
    ASSERT_EQ(found.size, wanted.size);
    ASSERT_EQ(found.levels.size(), wanted.levels.size());
    ASSERT_GT(wanted.levels.size(), 3u);
    EXPECT_EQ(found.metadata.at("lambent.roughness"), wanted.metadata.at("lambent.roughness"));
    for (std::size_t level = 0; level < wanted.levels.size(); ++level) {
        const Apart off = apart(found.levels[level], wanted.levels[level]);
        EXPECT_LE(off.relative_rmse, 5e-3) << "level " << level;
        EXPECT_LE(off.largest, 0.02) << "level " << level;
    }
}

TEST(Vulkan, BakesWhatTheProcessorBakes)
{
    const Folder folder;
    const auto bake = [&](const char* backend, const std::string& output) {
        return testing::run_program("env",
                                    {"LSAN_OPTIONS=detect_leaks=0", LAMBENT_PROGRAM, "bake", "studio",
                                     "--size", "16", "--backend", backend, "--stats", "json", "-o", output});
    };
    const Outcome there = bake("vulkan", folder.path("there.ktx2"));
    if (there.code == 4 && !std::getenv("LAMBENT_REQUIRE_VULKAN"))
        GTEST_SKIP() << there.error;
    ASSERT_EQ(there.code, 0) << there.error;
    const json stats = json::parse(there.output);
    EXPECT_EQ(stats["backend"], "vulkan");
    EXPECT_GE(stats["device_ms"].value("prefilter", -1.0), 0.0);
    EXPECT_LE(stats["error"], 0.01);
    const Outcome here = bake("cpu", folder.path("here.ktx2"));
    ASSERT_EQ(here.code, 0) << here.error;
    EXPECT_EQ(json::parse(here.output)["backend"], "cpu");
    EXPECT_FALSE(json::parse(here.output).contains("device_ms"));
    expect_alike(read_cube(folder.path("there.ktx2")), read_cube(folder.path("here.ktx2")));
}

TEST(Vulkan, WithoutADriverItSaysSoAndLeavesNothing)
{
    const Folder folder;
    const std::string command = "VK_ICD_FILENAMES=/nowhere VK_DRIVER_FILES=/nowhere exec '" LAMBENT_PROGRAM
                                "' render sphere --backend vulkan --bounces 0 -o '" +
                                folder.path("a.png") + "'";
    expect_refused(testing::run_program("sh", {"-c", command}), 4);
    const std::string bake = "VK_ICD_FILENAMES=/nowhere VK_DRIVER_FILES=/nowhere exec '" LAMBENT_PROGRAM
                             "' bake studio --backend vulkan -o '" +
                             folder.path("b") + "'";
    expect_refused(testing::run_program("sh", {"-c", bake}), 4);
    EXPECT_TRUE(folder.names().empty());
}

TEST(Vulkan, AutoGoesOnWithoutADriverAndSaysNothing)
{
    const Folder folder;
    const std::string command = "VK_ICD_FILENAMES=/nowhere VK_DRIVER_FILES=/nowhere exec '" LAMBENT_PROGRAM
                                "' render sphere --size 64x36 --backend auto --stats json -o '" +
                                folder.path("a.png") + "'";
    const Outcome outcome = testing::run_program("sh", {"-c", command});
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    EXPECT_EQ(json::parse(outcome.output)["backend"], "cpu");
    const std::string bake = "VK_ICD_FILENAMES=/nowhere VK_DRIVER_FILES=/nowhere exec '" LAMBENT_PROGRAM
                             "' bake studio --size 16 --stats json -o '" +
                             folder.path("b.ktx2") + "'";
    const Outcome baked = testing::run_program("sh", {"-c", bake});
    ASSERT_EQ(baked.code, 0) << baked.error;
    EXPECT_EQ(json::parse(baked.output)["backend"], "cpu");
}

TEST(Vulkan, DoesNotTrace)
{
    const Folder folder;
    expect_refused(lambent({"reference", "sphere", "-o", folder.path("a.png"), "--backend", "vulkan"}), 2);
    EXPECT_TRUE(folder.names().empty());
}

} // namespace
} // namespace lambent
