// `lambent reference` as its users meet it: what it takes, what it leaves, and how it is stopped.
#include "tests/cli/lambent.h"

#include "image/files/image_io.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lambent {
namespace {

using testing::Folder;
using testing::Outcome;

std::vector<std::string> traced(const std::string& output, const std::vector<std::string>& more)
{
    std::vector<std::string> words = {"reference", "sphere", "-o", output, "--env", "none"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

// The program run by another, which limits or ends it.
Outcome run_by(const std::string& program, std::vector<std::string> first,
               const std::vector<std::string>& words)
{
    first.push_back(LAMBENT_PROGRAM);
    first.insert(first.end(), words.begin(), words.end());
    return testing::run_program(program, first);
}

// A PNG with something in the middle and nothing in the corners.
void expect_whole_picture(const std::string& path, int width, int height)
{
    const image::CodeImage image = image::read_codes(path);
    ASSERT_EQ(image.width, width);
    ASSERT_EQ(image.height, height);
    ASSERT_EQ(image.channels, 4);
    const auto alpha = [&](int x, int y) {
        return int{image.bytes[4 * static_cast<std::size_t>(y * width + x) + 3]};
    };
    EXPECT_EQ(alpha(width / 2, height / 2), 255);
    EXPECT_EQ(alpha(0, 0), 0);
    EXPECT_EQ(alpha(width - 1, height - 1), 0);
}

TEST(Reference, WritesThePictureItsVarianceAndStatistics)
{
    const Folder folder;
    const Outcome outcome = lambent(
        traced(folder.path("a.exr"), {"--size", "40x30", "--spp", "4", "--background", "none", "--variance",
                                      folder.path("v.exr"), "--stats", "json", "--bounces", "3"}));
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    const image::ImageInfo picture = image::inspect(folder.path("a.exr"));
    EXPECT_EQ(picture.width, 40);
    EXPECT_EQ(picture.height, 30);
    EXPECT_NE(picture.detail.find("A B G R"), std::string::npos) << picture.detail;
    const image::ImageInfo variance = image::inspect(folder.path("v.exr"));
    EXPECT_EQ(variance.width, 40);
    EXPECT_EQ(variance.height, 30);
    const nlohmann::json stats = nlohmann::json::parse(outcome.output);
    EXPECT_EQ(stats["command"], "reference");
    EXPECT_EQ(stats["width"], 40);
    EXPECT_EQ(stats["height"], 30);
    EXPECT_EQ(stats["samples"], 4.0);
    EXPECT_EQ(stats["bounces"], 3);
    EXPECT_GT(stats["triangles"], 0);
    EXPECT_GT(stats["times_ms"]["trace"], 0.0);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.exr", "v.exr"}));
}

nlohmann::json stats_of(std::vector<std::string> words)
{
    words.insert(words.end(), {"--stats", "json"});
    const Outcome outcome = lambent(words);
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    return nlohmann::json::parse(outcome.output);
}

// One sample tells no noise; two do, of all pixels and, since the background has none, more of the covered ones.
TEST(Reference, SaysNothingOfNoiseThatItDoesNotKnow)
{
    const Folder folder;
    const auto stats = [&](const char* samples) {
        return stats_of({"reference", "sphere", "-o", folder.path("a.exr"), "--env", "studio", "--size",
                         "64x48", "--background", "0.2,0.2,0.2", "--spp", samples});
    };
    const nlohmann::json one = stats("1"), two = stats("2");
    EXPECT_TRUE(one.at("error").is_null());
    EXPECT_TRUE(one.at("error_covered").is_null());
    EXPECT_GT(two.at("error").get<double>(), 0.0);
    EXPECT_GT(two.at("error_covered").get<double>(), two.at("error").get<double>());
    EXPECT_EQ(two.at("error_cut"), 1.0);
}

// At so high an exposure that every pixel with light is cut, a display shows no noise of it.
TEST(Reference, NoiseIsThatOfExposedAndCutLight)
{
    const Folder folder;
    const auto noise = [&](const char* exposure) {
        return stats_of({"reference", "sphere", "-o", folder.path("a.exr"), "--env", "furnace", "--size",
                         "64x48", "--exposure", exposure, "--spp", "8"})
            .at("error_covered")
            .get<double>();
    };
    EXPECT_LT(noise("1000"), 0.1 * noise("0.001"));
}

TEST(Reference, VarianceNeedsTwoSamples)
{
    const Folder folder;
    const Outcome refused =
        lambent(traced(folder.path("a.exr"), {"--spp", "1", "--variance", folder.path("v.exr")}));
    EXPECT_EQ(refused.code, 2);
    EXPECT_EQ(refused.error, "lambent: error: --variance: needs two samples per pixel or more: --spp 2\n");
    const nlohmann::json stats = stats_of(traced(
        folder.path("a.exr"), {"--time", "0.0001", "--size", "48x32", "--variance", folder.path("v.exr")}));
    EXPECT_EQ(stats.at("samples"), 2.0);
    for (const float value : image::read_radiance(folder.path("v.exr")).values)
        ASSERT_TRUE(std::isfinite(value));
}

TEST(Reference, DisplaysWhatItTraced)
{
    const Folder folder;
    for (const char* name : {"a.png", "a.jpg", "a.hdr"}) {
        const Outcome outcome = lambent(traced(folder.path(name), {"--size", "24x16", "--spp", "1"}));
        ASSERT_EQ(outcome.code, 0) << outcome.error;
        EXPECT_EQ(image::inspect(folder.path(name)).width, 24);
    }
}

TEST(Reference, SeedsChangeTheNoiseAndNothingElseDoes)
{
    const Folder folder;
    const auto picture = [&](const char* seed, const char* threads) {
        const std::string path = folder.path(std::string(seed) + threads + ".exr");
        const Outcome outcome =
            lambent({"reference", "sphere", "-o", path, "--env", "furnace", "--size", "32x32", "--spp", "2",
                     "--background", "none", "--seed", seed, "--threads", threads});
        EXPECT_EQ(outcome.code, 0) << outcome.error;
        return image::read_radiance(path).values;
    };
    EXPECT_EQ(picture("0", "1"), picture("0", "2"));
    EXPECT_NE(picture("0", "1"), picture("1", "1"));
}

TEST(Reference, RefusesWhatIsOutOfRange)
{
    const Folder folder;
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"--bounces", "-1"},
                                               {"--bounces", "1025"},
                                               {"--bounces", "two"},
                                               {"--spp", "0"},
                                               {"--spp", "2.5"},
                                               {"--spp", "1048577"},
                                               {"--noise", "0"},
                                               {"--noise", "1.5"},
                                               {"--noise", "nan"},
                                               {"--time", "0"},
                                               {"--time", "-3"},
                                               {"--seed", "x"},
                                               {"--seed", "-1"},
                                               {"--variance", folder.path("v.png")},
                                               {"--samples-per-pixel", "3"}}) {
        const Outcome outcome = lambent(traced(folder.path("a.exr"), words));
        EXPECT_EQ(outcome.code, 2) << words[0] << ' ' << words[1] << ": " << outcome.error;
        EXPECT_EQ(outcome.error.rfind("lambent: error: ", 0), 0u) << outcome.error;
        EXPECT_NE(outcome.error.find(words[0]), std::string::npos) << outcome.error;
        EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1);
    }
    EXPECT_TRUE(folder.names().empty());
}

const std::vector<std::string> for_ever = {"--size", "48x48", "--spp", "1048576", "--background", "none"};

TEST(Reference, InterruptedItWritesWhatThereIs)
{
    const Folder folder;
    const Outcome outcome =
        run_by("timeout", {"--signal=INT", "--preserve-status", std::to_string(2 * testing::patience)},
               traced(folder.path("a.png"), for_ever));
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(outcome.error.rfind("lambent: warning: stopped early", 0), 0u) << outcome.error;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.png"});
    expect_whole_picture(folder.path("a.png"), 48, 48);
}

TEST(Reference, KilledItLeavesNothing)
{
    const Folder folder;
    const Outcome outcome = run_by("timeout", {"--signal=KILL", "1"}, traced(folder.path("a.exr"), for_ever));
    EXPECT_NE(outcome.code, 0);
    EXPECT_TRUE(folder.names().empty());
}

// As on a full disk: 512 or 1024 bytes, by the shell.
TEST(Reference, WhatCannotBeWrittenInFullIsNotLeftInPart)
{
    const Folder folder;
    const std::string path = folder.path("a.hdr"), before = "a picture of long ago";
    const auto limited = [&](const std::string& output) {
        return run_by("sh", {"-c", "ulimit -f 1; exec \"$0\" \"$@\""},
                      traced(output, {"--size", "256x256", "--spp", "1", "--background", "0.1,0.2,0.3"}));
    };
    const Outcome outcome = limited(path);
    EXPECT_EQ(outcome.code, 5) << outcome.error;
    EXPECT_EQ(outcome.error.rfind("lambent: error: " + path, 0), 0u) << outcome.error;
    EXPECT_TRUE(folder.names().empty());
    // What was there stays.
    write_bytes(path, before);
    EXPECT_EQ(limited(path).code, 5);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.hdr"});
    std::string after;
    std::getline(std::ifstream(path), after);
    EXPECT_EQ(after, before);
}

} // namespace
} // namespace lambent
