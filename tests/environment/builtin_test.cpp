// What all built-in environments promise: names, options, sizes, and numbers that can be drawn.
#include "environment/builtin/builtin.h"

#include "base/error.h"
#include "base/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace lambent::environment {
namespace {

constexpr float quarter_turn = 0.5f * std::numbers::pi_v<float>;

// The message of the usage error, or nothing.
std::string refusal(std::string_view name, const BuiltinOptions& options)
{
    try {
        make_builtin(name, options);
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::usage);
        return error.what();
    }
    return {};
}

void expect_sound(const image::RadianceImage& image, int width, const std::string& what)
{
    ASSERT_EQ(image.width, width) << what;
    ASSERT_EQ(image.height, width / 2) << what;
    ASSERT_EQ(image.channels, 3) << what;
    ASSERT_EQ(image.values.size(), static_cast<std::size_t>(3 * width * (width / 2))) << what;
    double sum = 0.0;
    for (const float value : image.values) {
        ASSERT_TRUE(std::isfinite(value) && value >= 0.0f) << what << ": " << value;
        sum += static_cast<double>(value);
    }
    EXPECT_GT(sum, 0.0) << what;
}

TEST(Builtin, KnowsItsNames)
{
    EXPECT_EQ(builtin_names().size(), 4u);
    for (const std::string_view name : builtin_names()) {
        EXPECT_TRUE(is_builtin(name));
        expect_sound(make_builtin(name, {.width = 64}), 64, std::string(name));
    }
    for (const std::string_view name : {"", "Sky", "sky ", "skyline", "none", "sky.hdr"}) {
        EXPECT_FALSE(is_builtin(name)) << name;
        EXPECT_NE(refusal(name, {}).find(text("'", name, "'")), std::string::npos);
    }
}

TEST(Builtin, AFurnaceIsOneEverywhere)
{
    for (const int width : {64, 512})
        for (const float value : make_builtin("furnace", {.width = width}).values)
            ASSERT_EQ(value, 1.0f);
}

TEST(Builtin, TheirUsualWidths)
{
    EXPECT_EQ(make_builtin("kitchen").width, 2048);
    EXPECT_EQ(make_builtin("furnace").width, 1024);
}

// Smaller and larger ones of the kitchen hold the same light.
TEST(Builtin, TheKitchenIsAsBrightAtEverySize)
{
    const auto light = [](int width) {
        const image::RadianceImage image = make_builtin("kitchen", {.width = width});
        double sum = 0.0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < 3 * width; ++x)
                sum += std::sin((y + 0.5) / image.height * std::numbers::pi) *
                       static_cast<double>(image.pixel(0, y)[x]);
        return sum / width / image.height;
    };
    const double usual = light(2048);
    for (const int width : {64, 512, 4096})
        EXPECT_NEAR(light(width), usual, 3e-3 * usual) << width;
}

TEST(Builtin, RefusesWidths)
{
    for (const int width : {-1024, -1, 1, 32, 63, 65, 96, 1000, 16384, std::numeric_limits<int>::min(),
                            std::numeric_limits<int>::max()})
        for (const std::string_view name : builtin_names())
            EXPECT_NE(refusal(name, {.width = width}).find("panorama width"), std::string::npos);
}

TEST(Builtin, RefusesSunsAndHazeThatItCannotDraw)
{
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (const float elevation : {-0.11f, 1.58f, nan, infinity, -infinity})
        EXPECT_NE(refusal("sky", {.width = 64, .sun_elevation = elevation}).find("elevation"),
                  std::string::npos);
    for (const float azimuth : {nan, infinity, -infinity})
        EXPECT_NE(refusal("sky", {.width = 64, .sun_azimuth = azimuth}).find("azimuth"), std::string::npos);
    for (const float turbidity : {-2.0f, 1.0f, 1.49f, 10.1f, nan, infinity})
        EXPECT_NE(refusal("sky", {.width = 64, .turbidity = turbidity}).find("turbidity"), std::string::npos);
}

TEST(Builtin, TheSkyIsSoundAtTheEdgesOfItsOptions)
{
    for (const float elevation : {-0.1f, -0.0096f, 0.0f, quarter_turn})
        for (const float turbidity : {1.5f, 10.0f}) {
            const int width = (elevation == 0.0f) == (turbidity > 5.0f) ? 64 : 256;
            expect_sound(make_builtin("sky", {width, 2.0f, elevation, turbidity}), width,
                         text("elevation ", elevation, ", turbidity ", turbidity));
        }

    for (const float azimuth : {3.1415927f, 1e6f})
        expect_sound(make_builtin("sky", {.width = 64, .sun_azimuth = azimuth}), 64,
                     text("azimuth ", azimuth));
}

TEST(Builtin, IsTheSameEachTime)
{
    for (const std::string_view name : builtin_names())
        EXPECT_EQ(make_builtin(name, {.width = 64}).values, make_builtin(name, {.width = 64}).values);
}

} // namespace
} // namespace lambent::environment
