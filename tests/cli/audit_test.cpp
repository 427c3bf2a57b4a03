// The error that `lambent render` measures, as its users meet it.
#include "tests/cli/lambent.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <sstream>

namespace lambent {
namespace {

using testing::Folder;
using testing::Outcome;
using Words = std::vector<std::string>;

std::string content(const std::string& path)
{
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    return bytes.str();
}

Outcome drawn(const std::string& output, const Words& more, const std::string& scene = "sphere")
{
    Words words = {"render", scene, "-o", output, "--size", "128x72", "--no-cache", "--stats", "json"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = lambent(words);
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    return outcome;
}

nlohmann::json stats_of(const Outcome& outcome)
{
    return nlohmann::json::parse(outcome.output);
}

TEST(Audit, PicturesWithoutBouncesAreAuditedOnlyOnRequest)
{
    const Folder folder;
    const nlohmann::json plain = stats_of(drawn(folder.path("a.png"), {"--bounces", "0"})),
                         asked = stats_of(drawn(folder.path("b.png"), {"--bounces", "0", "--audit"}));
    EXPECT_FALSE(plain.contains("error"));
    EXPECT_FALSE(plain["times_ms"].contains("audit"));
    EXPECT_GT(asked["times_ms"]["audit"], 0.0);
    const nlohmann::json& error = asked["error"];
    EXPECT_EQ(error["confidence"], 0.95);
    EXPECT_EQ(error["pixels"], 512);
    EXPECT_LE(error["low"], error["relative_rmse"]);
    EXPECT_LE(error["relative_rmse"], error["high"]);
    EXPECT_GT(error["high"], 0.0);
    EXPECT_LT(error["high"], 0.2);
    EXPECT_EQ(content(folder.path("a.png")).find("lambent.error"), std::string::npos);
    EXPECT_NE(content(folder.path("b.png")).find("lambent.error"), std::string::npos);
}

// One bounce is enough.
TEST(Audit, PicturesWithBouncesAreAuditedUnlessTheyAreNot)
{
    const Folder folder;
    EXPECT_TRUE(stats_of(drawn(folder.path("a.png"), {"--bounces", "1"})).contains("error"));
    EXPECT_FALSE(stats_of(drawn(folder.path("b.png"), {"--bounces", "1", "--no-audit"})).contains("error"));
    EXPECT_EQ(content(folder.path("b.png")).find("lambent.error"), std::string::npos);
}

// The picture, with the error in its file, is that of the command that names its passes.
TEST(Audit, AnErrorThatIsAskedForIsReached)
{
    const Folder folder;
    const nlohmann::json stats = stats_of(drawn(
        folder.path("a.png"), {"--bounces", "2", "--error", "0.035", "--background", "none"}, "report"));
    EXPECT_GT(stats["error"]["relative_rmse"], 0.0);
    EXPECT_LE(stats["error"]["relative_rmse"], 0.035);
    const std::string passes = std::to_string(stats["passes"].get<int>());
    EXPECT_GT(stats["passes"].get<int>(), 2);
    drawn(folder.path("b.png"), {"--bounces", "2", "--passes", passes, "--background", "none"}, "report");
    EXPECT_EQ(content(folder.path("a.png")), content(folder.path("b.png")));
}

TEST(Audit, TimeIsSpentOnPassesThatAreTold)
{
    const Folder folder;
    const nlohmann::json stats =
        stats_of(drawn(folder.path("a.png"), {"--bounces", "2", "--time", "0.5"}, "report"));
    const std::string passes = std::to_string(stats["passes"].get<int>());
    drawn(folder.path("b.png"), {"--bounces", "2", "--passes", passes}, "report");
    EXPECT_EQ(content(folder.path("a.png")), content(folder.path("b.png")));
}

TEST(Audit, EveryFormatCarriesTheSameNumbers)
{
    const Folder folder;
    const std::regex numbers("lambent.error.{1,14}?(0[.0-9]+ 0[.0-9]* 0[.0-9]+)");
    std::string first;
    for (const char* name : {"a.png", "a.jpg", "a.exr", "a.hdr"}) {
        const Outcome outcome = drawn(folder.path(name), {"--audit"}, "report");
        const std::string bytes = content(folder.path(name));
        // Zeros in the file are no characters of a regular expression's text.
        std::string text;
        for (const char c : bytes.substr(0, 4000))
            text += c >= ' ' && c <= '~' ? c : '_';
        std::smatch match;
        ASSERT_TRUE(std::regex_search(text, match, numbers)) << name;
        first = first.empty() ? match[1].str() : first;
        EXPECT_EQ(match[1].str(), first) << name;
        std::istringstream words(match[1].str());
        double value = 0.0, low = 0.0, high = 0.0;
        words >> value >> low >> high;
        const nlohmann::json error = stats_of(outcome)["error"];
        EXPECT_NEAR(value, error["relative_rmse"], 1e-3 * value);
        EXPECT_NEAR(low, error["low"], 1e-3 * low);
        EXPECT_NEAR(high, error["high"], 1e-3 * high);
    }
}

TEST(Audit, TheErrorIsRemarkedInPercent)
{
    const Folder folder;
    const Outcome outcome = drawn(folder.path("a.png"), {"--audit", "--verbose"});
    EXPECT_TRUE(std::regex_search(
        outcome.error, std::regex("error [0-9]+(\\.[0-9]+)? % \\([0-9.]+ to [0-9]+(\\.[0-9]+)?\\)")))
        << outcome.error;
}

TEST(Audit, NothingSeenHasNoError)
{
    const Folder folder;
    const nlohmann::json stats = stats_of(drawn(folder.path("a.png"), {"--audit", "--env", "none"}));
    EXPECT_TRUE(stats["error"].is_null());
    EXPECT_EQ(content(folder.path("a.png")).find("lambent.error"), std::string::npos);
}

// `compare --covered` measures what the audit estimates.
TEST(Audit, TheErrorIsThatOfCompare)
{
    const Folder folder;
    const nlohmann::json error = stats_of(
        drawn(folder.path("a.exr"), {"--bounces", "0", "--audit", "--exposure", "2"}, "report"))["error"];
    const Outcome traced = lambent({"reference", "report", "-o", folder.path("r.exr"), "--size", "128x72",
                                    "--bounces", "0", "--spp", "512", "--seed", "3"});
    ASSERT_EQ(traced.code, 0) << traced.error;
    const Outcome compared = lambent({"compare", folder.path("a.exr"), folder.path("r.exr"), "--covered",
                                      "--exposure", "2", "--clamp", "1"});
    const double truth = nlohmann::json::parse(compared.output)["relative_rmse"];
    // Not a promise for one picture: four half widths off has a probability below 1e-4.
    const double low = error["low"], high = error["high"];
    EXPECT_GT(truth, low - 0.5 * (high - low));
    EXPECT_LT(truth, high + 0.5 * (high - low));
}

TEST(Audit, WhatCannotBeAuditedIsRefused)
{
    const Folder folder;
    const Outcome both = lambent({"render", "sphere", "-o", folder.path("a.png"), "--audit", "--no-audit"});
    EXPECT_EQ(both.code, 2);
    EXPECT_NE(both.error.find("exclude each other"), std::string::npos);
    const Outcome report = lambent({"render", "sphere", "-o", folder.path("a.png"), "--audit", "--model",
                                    "phong", "--pipeline", "report"});
    EXPECT_EQ(report.code, 2);
    EXPECT_NE(report.error.find("--audit"), std::string::npos);
    EXPECT_EQ(lambent({"render", "sphere", "-o", folder.path("a.png"), "--bounces", "1025"}).code, 2);
    EXPECT_TRUE(folder.names().empty());
}

} // namespace
} // namespace lambent
