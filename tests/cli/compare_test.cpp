// `lambent compare` as its users meet it.
#include "tests/cli/lambent.h"

#include "image/image_io.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace lambent {
namespace {

using testing::Folder;
using testing::Outcome;

std::string write_light(const Folder& folder, const std::string& name, float value, int width = 40)
{
    image::RadianceImage image{width, 20, 3, {}};
    image.values.assign(static_cast<std::size_t>(width) * 60, value);
    image::write_radiance(image, folder.path(name));
    return folder.path(name);
}

std::string write_grey(const Folder& folder, const std::string& name, std::uint8_t code)
{
    image::CodeImage image{40, 20, 3, 8, std::vector<std::uint8_t>(2400, code)};
    image::write_codes(image, folder.path(name));
    return folder.path(name);
}

void expect_failure(const Outcome& outcome, int code, const std::string& part)
{
    EXPECT_EQ(outcome.code, code) << outcome.error;
    EXPECT_EQ(outcome.error.rfind("lambent: error: ", 0), 0u) << outcome.error;
    EXPECT_NE(outcome.error.find(part), std::string::npos) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
}

TEST(Compare, PrintsTheNumbers)
{
    const Folder folder;
    const std::string a = write_light(folder, "a.exr", 3.0f), b = write_light(folder, "b.exr", 2.0f);
    const Outcome outcome = lambent({"compare", a, b});
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    const nlohmann::json json = nlohmann::json::parse(outcome.output);
    EXPECT_DOUBLE_EQ(json["rmse"], 1.0);
    EXPECT_DOUBLE_EQ(json["relative_rmse"], 0.5);
    EXPECT_NEAR(json["psnr"].get<double>(), 6.0206, 1e-4); // 20 log10(2)
    EXPECT_DOUBLE_EQ(json["max"], 1.0);
    EXPECT_GT(json["flip"].get<double>(), 0.0);
    EXPECT_EQ(json["kind"], "light");
    EXPECT_EQ(json["width"], 40);
}

TEST(Compare, EqualPicturesHaveNoPsnr)
{
    const Folder folder;
    const std::string a = write_grey(folder, "a.png", 100);
    const nlohmann::json json = nlohmann::json::parse(lambent({"compare", a, a}).output);
    EXPECT_TRUE(json["psnr"].is_null());
    EXPECT_EQ(json["flip"], 0.0);
    EXPECT_EQ(json["kind"], "codes");
}

TEST(Compare, ClampAndExposureComeFirst)
{
    const Folder folder;
    const std::string a = write_light(folder, "a.exr", 3.0f), b = write_light(folder, "b.hdr", 2.0f);
    const auto rmse = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"compare", a, b});
        return nlohmann::json::parse(lambent(more).output)["rmse"].get<double>();
    };
    EXPECT_DOUBLE_EQ(rmse({"--clamp", "1"}), 0.0);
    EXPECT_DOUBLE_EQ(rmse({"--clamp", "2.5"}), 0.5);
    EXPECT_DOUBLE_EQ(rmse({"--exposure", "4"}), 4.0);
    EXPECT_DOUBLE_EQ(rmse({"--exposure", "0.25", "--clamp", "0.625"}), 0.125);
}

TEST(Compare, BoundsDecideTheExitCode)
{
    const Folder folder;
    const std::string a = write_light(folder, "a.exr", 3.0f), b = write_light(folder, "b.exr", 2.0f);
    EXPECT_EQ(lambent({"compare", a, b, "--max-rel", "0.5", "--max-flip", "1"}).code, 0);
    const Outcome over = lambent({"compare", a, b, "--max-rel", "0.49"});
    expect_failure(over, 1, "relative RMSE 0.5 is above the bound of 0.49");
    EXPECT_TRUE(nlohmann::json::accept(over.output)); // the numbers all the same
    expect_failure(lambent({"compare", a, b, "--max-flip", "0.000001"}), 1, "FLIP");
}

TEST(Compare, WhatCannotBeComparedIsRefused)
{
    const Folder folder;
    const std::string a = write_light(folder, "a.exr", 1.0f),
                      wide = write_light(folder, "wide.exr", 1.0f, 60);
    const std::string codes = write_grey(folder, "codes.png", 100), heat = folder.path("heat.png");
    expect_failure(lambent({"compare", a, wide, "-o", heat}), 3, "is 40x20 and");
    expect_failure(lambent({"compare", a, codes, "-o", heat}), 3, "holds linear light");
    expect_failure(lambent({"compare", a, folder.path("missing.exr")}), 3, "missing.exr");
    expect_failure(lambent({"compare", a, a, "-o", folder.path("heat.exr")}), 2, "a heat map's name");
    expect_failure(lambent({"compare", codes, codes, "--exposure", "2"}), 2, "--exposure");
    expect_failure(lambent({"compare", a, a, "--heat", "warm"}), 2, "none of flip");
    EXPECT_EQ(folder.names().size(), 3u);
}

TEST(Compare, WritesHeatMapsOfEachKind)
{
    const Folder folder;
    const std::string a = write_light(folder, "a.exr", 3.0f), b = write_light(folder, "b.exr", 2.0f);
    for (const char* kind : {"flip", "relative", "absolute"}) {
        const std::string heat = folder.path(std::string(kind) + ".png");
        ASSERT_EQ(lambent({"compare", a, b, "-o", heat, "--heat", kind}).code, 0);
        const image::CodeImage map = image::read_codes(heat);
        EXPECT_EQ(map.width, 40);
        EXPECT_GT(map.height, 20);
        EXPECT_GT(map.bytes[0], 20) << kind; // there is a difference in the corner
    }
}

TEST(Compare, BrokenValuesAreCountedAndWarnedOf)
{
    const Folder folder;
    image::RadianceImage image{4, 4, 3, std::vector<float>(48, 1.0f)};
    image.values[7] = std::numeric_limits<float>::quiet_NaN();
    image::write_radiance(image, folder.path("nan.exr"));
    const Outcome outcome = lambent({"compare", folder.path("nan.exr"), folder.path("nan.exr")});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.error.find("1 values are not finite"), std::string::npos) << outcome.error;
}

} // namespace
} // namespace lambent
