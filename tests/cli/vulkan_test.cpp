// `--backend vulkan` as its users meet it.
#include "tests/cli/lambent.h"

#include "image/image_io.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace lambent {
namespace {

using nlohmann::json;
using testing::Folder;
using testing::Outcome;

// Drivers keep some memory to the end of the program, which is no leak of ours.
Outcome drawn(const std::string& output, const std::vector<std::string>& more)
{
    std::vector<std::string> words = {
        "LSAN_OPTIONS=detect_leaks=0", LAMBENT_PROGRAM, "render", "report", "-o", output, "--size", "96x54"};
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
}

TEST(Vulkan, WithoutADriverItSaysSoAndLeavesNothing)
{
    const Folder folder;
    const std::string command = "VK_ICD_FILENAMES=/nowhere VK_DRIVER_FILES=/nowhere exec '" LAMBENT_PROGRAM
                                "' render sphere --backend vulkan -o '" +
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
