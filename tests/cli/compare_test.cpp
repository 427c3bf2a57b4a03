// `lambent compare` as its users meet it.
#include "tests/cli/lambent.h"

#include "image/files/image_io.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace lambent {
namespace {

using testing::Folder;
using testing::Outcome;

// Grey light that grows from left to right, times a factor.
std::string write_light(const Folder& folder, const std::string& name, float factor, int width = 40)
{
    image::RadianceImage light{width, 20, 3, {}};
    for (int i = 0; i < width * 20; ++i)
        light.values.insert(light.values.end(), 3, factor * static_cast<float>(1 + i % width));
    image::write_radiance(light, folder.path(name));
    return folder.path(name);
}

std::string write_codes(const Folder& folder, const std::string& name, std::uint8_t code)
{
    image::write_codes({30, 10, 3, 8, std::vector<std::uint8_t>(900, code)}, folder.path(name));
    return folder.path(name);
}

nlohmann::json json_of(const Outcome& outcome, int code = 0)
{
    EXPECT_EQ(outcome.code, code) << outcome.error;
    EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
    return nlohmann::json::parse(outcome.output);
}

void expect_refused(const std::vector<std::string>& words, int code, const std::string& part)
{
    const Outcome outcome = lambent(words);
    EXPECT_EQ(outcome.code, code) << outcome.error;
    EXPECT_EQ(outcome.error.rfind("lambent: error: ", 0), 0u) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_NE(outcome.error.find(part), std::string::npos) << outcome.error;
    EXPECT_EQ(outcome.output, "");
}

// What a program shows on a terminal of its own.
std::string on_a_terminal(const std::vector<std::string>& words)
{
    std::string command = "'" LAMBENT_PROGRAM "'";
    for (const std::string& word : words)
        command += " '" + word + "'";
    const Outcome outcome = testing::run_program("script", {"-qec", command, "/dev/null"});
    EXPECT_EQ(outcome.code, 0) << outcome.output << outcome.error;
    return outcome.output;
}

TEST(Compare, ATerminalGetsATableAndAPipeJson)
{
    const Folder folder;
    const std::string a = write_light(folder, "a.exr", 1.1f), b = write_light(folder, "b.exr", 1.0f);
    const std::string table = on_a_terminal({"compare", a, b});
    EXPECT_EQ(table.find('{'), std::string::npos) << table;
    // Light from 1 to 40, a tenth more: RMSE .1 sqrt(41 * 81 / 6), the mean 20.5, PSNR 20 log10(40 / RMSE).
    for (const char* part :
         {"linear light", "40x20", "RMSE                2.353", "11.48 %", "24.61 dB", "HDR-FLIP"})
        EXPECT_NE(table.find(part), std::string::npos) << part << " is not in\n" << table;
    EXPECT_EQ(on_a_terminal({"compare", a, b, "--json"}).rfind("{\"rmse\"", 0), 0u);
    const std::string equal = on_a_terminal({"compare", a, a});
    EXPECT_NE(equal.find("the pictures are equal"), std::string::npos) << equal;
}

TEST(Compare, LightIsMeasuredAsItIs)
{
    const Folder folder;
    const std::string a = write_light(folder, "a.exr", 1.1f), b = write_light(folder, "b.exr", 1.0f);
    const Outcome outcome = lambent({"compare", a, b});
    EXPECT_EQ(outcome.error, "");
    const nlohmann::json json = json_of(outcome);
    // The mean of 1 to 40 and of their squares, by the sums' formulas.
    const double mean = 20.5, mean_square = 41.0 * 81.0 / 6.0;
    EXPECT_NEAR(json["rmse"].get<double>(), 0.1 * std::sqrt(mean_square), 1e-5);
    EXPECT_NEAR(json["relative_rmse"].get<double>(), 0.1 * std::sqrt(mean_square) / mean, 1e-6);
    EXPECT_NEAR(json["psnr"].get<double>(), 20.0 * std::log10(40.0 / (0.1 * std::sqrt(mean_square))), 1e-4);
    EXPECT_NEAR(json["max"].get<double>(), 4.0, 1e-5);
    EXPECT_GT(json["flip"].get<double>(), 0.01);
    EXPECT_LT(json["flip"].get<double>(), 0.5);
    EXPECT_EQ(json["width"], 40);
    EXPECT_EQ(json["height"], 20);
    EXPECT_EQ(json["kind"], "linear");
    EXPECT_EQ(json["flip_exposures"]["count"], 2);
}

// Grey light in a picture whose left half is covered, the outermost column by a hundredth.
std::string write_half_covered(const Folder& folder, const std::string& name, float covered, float outside)
{
    image::RadianceImage light{40, 20, 4, {}};
    for (int i = 0; i < 40 * 20; ++i) {
        const int x = i % 40;
        light.values.insert(light.values.end(), 3, x < 20 ? covered : outside);
        light.values.push_back(x == 19 ? 0.01f : x < 20 ? 1.0f : 0.0f);
    }
    image::write_radiance(light, folder.path(name));
    return folder.path(name);
}

TEST(Compare, OnlyWhatSurfacesCover)
{
    const Folder folder;
    const std::string a = write_half_covered(folder, "a.exr", 1.1f, 5.0f),
                      b = write_half_covered(folder, "b.exr", 1.0f, 1.0f);
    const nlohmann::json all = json_of(lambent({"compare", a, b})),
                         covered = json_of(lambent({"compare", a, b, "--covered", "--max-rel", "0.11"}));
    EXPECT_NEAR(all["relative_rmse"].get<double>(), std::sqrt((0.01 + 16.0) / 2.0), 1e-6);
    EXPECT_NEAR(covered["relative_rmse"].get<double>(), 0.1, 1e-6);
    EXPECT_NEAR(covered["max"].get<double>(), 0.1, 1e-6);
    EXPECT_LT(covered["flip"].get<double>(), all["flip"].get<double>());
    EXPECT_EQ(covered["covered"], 400);
    EXPECT_FALSE(all.contains("covered"));
    EXPECT_NE(on_a_terminal({"compare", a, b, "--covered"}).find("400 that surfaces cover"),
              std::string::npos);
}

TEST(Compare, CoverageHasToBeThere)
{
    const Folder folder;
    const std::string covered = write_half_covered(folder, "a.exr", 1.0f, 1.0f),
                      bare = write_light(folder, "b.exr", 1.0f), codes = write_codes(folder, "c.png", 255);
    expect_refused({"compare", covered, bare, "--covered"}, 3, "b.exr: --covered: has no alpha channel");
    expect_refused({"compare", codes, codes, "--covered"}, 3, "c.png: --covered: has no alpha channel");
    image::RadianceImage empty{8, 8, 4, std::vector<float>(256, 0.0f)};
    image::write_radiance(empty, folder.path("empty.exr"));
    expect_refused({"compare", folder.path("empty.exr"), folder.path("empty.exr"), "--covered"}, 3,
                   "no surface covers any pixel");
}

TEST(Compare, CodesAreMeasuredFromZeroToOne)
{
    const Folder folder;
    const std::string a = write_codes(folder, "a.png", 255), b = write_codes(folder, "b.png", 0);
    const nlohmann::json json = json_of(lambent({"compare", a, b}));
    EXPECT_EQ(json["rmse"], 1.0);
    EXPECT_EQ(json["psnr"], 0.0);
    EXPECT_NEAR(json["flip"].get<double>(), 0.967380, 2e-6);
    EXPECT_EQ(json["kind"], "srgb");
    EXPECT_TRUE(json["relative_rmse"].is_null());
}

TEST(Compare, EqualPicturesHaveNoFinitePsnr)
{
    const Folder folder;
    const std::string a = write_light(folder, "a.hdr", 1.0f);
    const nlohmann::json json = json_of(lambent({"compare", a, a, "--max-flip", "0", "--max-rel", "0"}));
    EXPECT_TRUE(json["psnr"].is_null());
    for (const char* key : {"rmse", "relative_rmse", "flip", "max"})
        EXPECT_EQ(json[key], 0.0) << key;
}

TEST(Compare, ExposureComesBeforeClamp)
{
    const Folder folder;
    const std::string a = write_light(folder, "a.exr", 1.5f), b = write_light(folder, "b.exr", 1.0f);
    // Only the leftmost column is below 1.5 after a factor of a half: 0.75 and 0.5; the second is 1.5 and 1.
    const nlohmann::json json = json_of(lambent({"compare", a, b, "--exposure", "0.5", "--clamp", "1.5"}));
    EXPECT_NEAR(json["max"].get<double>(), 0.5, 1e-6);
    EXPECT_NEAR(json["rmse"].get<double>(), std::sqrt((0.25 * 0.25 + 0.5 * 0.5) / 40.0), 1e-6);
    EXPECT_NEAR(json["psnr"].get<double>(), 20.0 * std::log10(1.5 / json["rmse"].get<double>()), 1e-6);
    expect_refused(
        {"compare", write_codes(folder, "a.png", 1), write_codes(folder, "b.png", 2), "--exposure", "2"}, 2,
        "--exposure");
}

TEST(Compare, BoundsGiveExitCodeOneAndTheJson)
{
    const Folder folder;
    const std::string a = write_light(folder, "a.exr", 1.1f), b = write_light(folder, "b.exr", 1.0f);
    const Outcome over = lambent({"compare", a, b, "--max-rel", "0.1", "--max-flip", "0.9"});
    EXPECT_GT(json_of(over, 1)["relative_rmse"].get<double>(), 0.1);
    EXPECT_EQ(over.error.rfind("lambent: error: ", 0), 0u);
    EXPECT_EQ(std::count(over.error.begin(), over.error.end(), '\n'), 1);
    EXPECT_NE(over.error.find("--max-rel"), std::string::npos);
    EXPECT_EQ(over.error.find("--max-flip"), std::string::npos);
    const Outcome both = lambent({"compare", a, b, "--max-rel", "0.1", "--max-flip", "0.001"});
    EXPECT_EQ(both.code, 1);
    EXPECT_NE(both.error.find("--max-rel"), std::string::npos);
    EXPECT_NE(both.error.find("--max-flip"), std::string::npos);
    EXPECT_EQ(lambent({"compare", a, b, "--max-rel", "0.2", "--max-flip", "0.9"}).code, 0);
}

TEST(Compare, HeatMapsAreWritten)
{
    const Folder folder;
    const std::string a = write_light(folder, "a.exr", 1.1f), b = write_light(folder, "b.exr", 1.0f);
    for (const char* heat : {"flip", "relative", "absolute"}) {
        const std::string output = folder.path(std::string(heat) + ".png");
        json_of(lambent({"compare", a, b, "-o", output, "--heat", heat}));
        const image::ImageInfo info = image::inspect(output);
        EXPECT_GE(info.width, 40);
        EXPECT_GT(info.height, 20);
    }
    EXPECT_EQ(folder.names().size(), 5u);
}

TEST(Compare, OtherSizesAndKindsAreBadInputAndLeaveNoMap)
{
    const Folder folder;
    const std::string a = write_light(folder, "a.exr", 1.0f), wide = write_light(folder, "w.exr", 1.0f, 41);
    const std::string codes = write_codes(folder, "c.png", 9), output = folder.path("heat.png");
    expect_refused({"compare", a, wide, "-o", output}, 3, "41x20");
    expect_refused({"compare", a, codes, "-o", output}, 3, "srgb");
    expect_refused({"compare", a, folder.path("none.exr"), "-o", output}, 3, "none.exr");
    write_bytes(folder.path("broken.exr"), "no picture at all");
    expect_refused({"compare", folder.path("broken.exr"), a, "-o", output}, 3, "broken.exr");
    EXPECT_FALSE(std::filesystem::exists(output));
}

TEST(Compare, WhatCannotBeWrittenIsSaidBeforeTheWork)
{
    const Folder folder;
    const std::string a = write_light(folder, "a.exr", 1.0f);
    expect_refused({"compare", a, a, "-o", folder.path("no/heat.png")}, 5, "heat.png");
    expect_refused({"compare", a, a, "-o", folder.path("heat.exr")}, 2, ".png or .jpg");
    EXPECT_EQ(folder.names().size(), 1u);
}

TEST(Compare, BadUsage)
{
    expect_refused({"compare", "a.exr"}, 2, "reference");
    expect_refused({"compare", "a.exr", "b.exr", "--heat", "flip"}, 2, "--heat");
    expect_refused({"compare", "a.exr", "b.exr", "-o", "x.png", "--heat", "warm"}, 2, "warm");
    expect_refused({"compare", "a.exr", "b.exr", "--clamp", "0"}, 2, "--clamp");
    expect_refused({"compare", "a.exr", "b.exr", "--max-flip", "-1"}, 2, "--max-flip");
    expect_refused({"compare", "a.exr", "b.exr", "--max-rel", "much"}, 2, "--max-rel");
    expect_refused({"compare", "a.exr", "b.exr", "--ppd", "0.1"}, 2, "--ppd");
}

TEST(Compare, NanIsWarnedOfAndQuietIsQuiet)
{
    const Folder folder;
    const std::string a = folder.path("a.exr"), b = folder.path("b.exr");
    image::write_radiance({2, 1, 3, {std::numeric_limits<float>::quiet_NaN(), 1, 1, 1, 1, 1}}, a);
    image::write_radiance({2, 1, 3, {1, 1, 1, 1, 1, 1}}, b);
    const Outcome outcome = lambent({"compare", a, b});
    EXPECT_EQ(json_of(outcome)["max"], 1.0);
    EXPECT_EQ(outcome.error.rfind("lambent: warning: ", 0), 0u) << outcome.error;
    EXPECT_EQ(lambent({"compare", a, b, "--quiet"}).error, "");
}

} // namespace
} // namespace lambent
