// `lambent reference --denoise` as its users meet it.
#include "tests/cli/lambent.h"

#include "image/files/image_io.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <regex>
#include <sstream>

namespace lambent {
namespace {

using testing::Folder;
using testing::Outcome;
using Words = std::vector<std::string>;

Words words_of(const std::string& output, const Words& more)
{
    Words words = {"reference", "report", "-o", output, "--size", "96x54", "--bounces", "2"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

nlohmann::json traced(const std::string& output, Words more)
{
    more.insert(more.end(), {"--stats", "json"});
    const Outcome outcome = lambent(words_of(output, more));
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    return nlohmann::json::parse(outcome.output);
}

std::string bytes_of(const std::string& path)
{
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    return bytes.str();
}

double error_of(const std::string& picture, const std::string& truth)
{
    const Outcome outcome = lambent({"compare", picture, truth, "--covered", "--clamp", "1"});
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    return nlohmann::json::parse(outcome.output)["relative_rmse"];
}

// The audit's interval is one of 95 %: with its halves doubled it holds the error but once in thousands.
TEST(Denoise, TheAuditedErrorIsThatOfCompareAndInEveryFile)
{
    const Folder folder;
    traced(folder.path("truth.exr"), {"--spp", "1024", "--seed", "9"});
    for (const char* name : {"a.exr", "a.png", "a.jpg", "a.hdr"}) {
        const nlohmann::json stats = traced(folder.path(name), {"--spp", "8", "--denoise"});
        const double low = stats["denoised_error"]["low"], high = stats["denoised_error"]["high"],
                     noise = stats["error_covered"];
        EXPECT_LT(stats["denoised_error"]["relative_rmse"], 0.8 * noise);
        EXPECT_GT(stats["times_ms"]["audit"], 0.0);
        EXPECT_GT(stats["times_ms"]["denoise"], 0.0);
        EXPECT_NE(bytes_of(folder.path(name)).find("lambent.error"), std::string::npos) << name;
        if (std::string(name) == "a.exr") {
            const double truth = error_of(folder.path(name), folder.path("truth.exr"));
            EXPECT_GT(truth, low - 0.5 * (high - low));
            EXPECT_LT(truth, high + 0.5 * (high - low));
        }
    }
}

// Better at each number of samples, and the better the more.
TEST(Denoise, IsBetterThanTheNoiseAtEveryNumberOfSamples)
{
    const Folder folder;
    for (const Words& scene :
         std::vector<Words>{{"--env", "kitchen"}, {"--env", "sky", "--model", "phong"}}) {
        const auto with = [&](Words words) {
            words.insert(words.end(), scene.begin(), scene.end());
            return words;
        };
        traced(folder.path("truth.exr"), with({"--spp", "1024", "--seed", "9"}));
        double last = 1e9;
        for (const char* samples : {"1", "2", "4", "16", "64", "256"}) {
            traced(folder.path("raw.exr"), with({"--spp", samples}));
            traced(folder.path("filtered.exr"), with({"--spp", samples, "--denoise", "--no-audit"}));
            const double raw = error_of(folder.path("raw.exr"), folder.path("truth.exr")),
                         filtered = error_of(folder.path("filtered.exr"), folder.path("truth.exr"));
            std::printf("%s, %s samples: noise %.4f, filtered %.4f\n", scene[1].c_str(), samples, raw,
                        filtered);
            EXPECT_LT(filtered, raw) << samples;
            EXPECT_LT(filtered, last) << samples;
            last = filtered;
        }
    }
}

TEST(Denoise, WithoutTheAuditThereIsNoErrorAndTheSamePicture)
{
    const Folder folder;
    traced(folder.path("a.exr"), {"--spp", "4", "--denoise"});
    const nlohmann::json stats = traced(folder.path("b.exr"), {"--spp", "4", "--denoise", "--no-audit"});
    EXPECT_FALSE(stats.contains("denoised_error"));
    EXPECT_EQ(bytes_of(folder.path("b.exr")).find("lambent.error"), std::string::npos);
    EXPECT_EQ(image::read_radiance(folder.path("a.exr")).values,
              image::read_radiance(folder.path("b.exr")).values);
}

TEST(Denoise, ThreadsDoNotChangeThePicture)
{
    const Folder folder;
    std::string first;
    for (const char* threads : {"1", "2", "3"}) {
        traced(folder.path("a.exr"), {"--spp", "3", "--denoise", "--no-audit", "--threads", threads});
        const std::string bytes = bytes_of(folder.path("a.exr"));
        first = first.empty() ? bytes : first;
        EXPECT_EQ(bytes, first) << threads;
    }
}

TEST(Denoise, WithoutItNothingIsFilteredOrAudited)
{
    const Folder folder;
    const nlohmann::json stats = traced(folder.path("a.exr"), {"--spp", "2"});
    EXPECT_FALSE(stats.contains("denoised_error"));
    EXPECT_FALSE(stats["times_ms"].contains("denoise"));
    EXPECT_EQ(bytes_of(folder.path("a.exr")).find("lambent.error"), std::string::npos);
}

TEST(Denoise, TheErrorIsRemarkedBesideTheNoise)
{
    const Folder folder;
    const Outcome outcome = lambent(words_of(folder.path("a.png"), {"--spp", "4", "--denoise", "--verbose"}));
    EXPECT_TRUE(std::regex_search(outcome.error, std::regex("error [0-9.]+ % \\([0-9.]+ to [0-9.]+\\); "
                                                            "noise before the filter [0-9.]+%")))
        << outcome.error;
}

// Whatever ends the tracing, the filter takes what there is: halfway in a round, too.
TEST(Denoise, EveryLimitEndsInAFilteredPicture)
{
    const Folder folder;
    for (const Words& limit : std::vector<Words>{{"--noise", "0.2"}, {"--time", "0.3"}, {"--spp", "1"}}) {
        Words words = limit;
        words.insert(words.end(), {"--denoise", "--no-audit"});
        const nlohmann::json stats = traced(folder.path("a.exr"), words);
        EXPECT_GT(stats["times_ms"]["denoise"], 0.0);
        for (const float value : image::read_radiance(folder.path("a.exr")).values)
            ASSERT_TRUE(std::isfinite(value));
    }
}

TEST(Denoise, WhatMakesNoSenseIsRefused)
{
    const Folder folder;
    for (const Words& words :
         std::vector<Words>{{"--denoise", "--variance", folder.path("v.exr")}, {"--no-audit"}}) {
        const Outcome outcome = lambent(words_of(folder.path("a.png"), words));
        EXPECT_EQ(outcome.code, 2) << outcome.error;
        EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1);
        EXPECT_NE(outcome.error.find("--denoise"), std::string::npos) << outcome.error;
    }
    EXPECT_TRUE(folder.names().empty());
}

} // namespace
} // namespace lambent
