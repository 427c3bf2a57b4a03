// The colours of errors and their legend.
#include "compare/color_map.h"
#include "compare/heat_map.h"
#include "compare/pixel_font.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace lambent::compare {
namespace {

double light_of(std::uint8_t code)
{
    const double c = code / 255.0;
    return c > 0.04045 ? std::pow((c + 0.055) / 1.055, 2.4) : c / 12.92;
}

// CIE L*, from the luminance of Rec. 709.
double lightness(const Code& color)
{
    const double y = 0.2126 * light_of(color[0]) + 0.7152 * light_of(color[1]) + 0.0722 * light_of(color[2]);
    return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
}

Code pixel(const image::CodeImage& image, int x, int y)
{
    const std::uint8_t* p = image.bytes.data() + 3 * (y * image.width + x);
    return {p[0], p[1], p[2]};
}

TEST(ColorMap, LightnessGrowsEvenly)
{
    for (int i = 0; i <= 255; ++i) {
        const float error = static_cast<float>(i) / 255.0f;
        EXPECT_NEAR(lightness(color_of(error)), 96.0 * i / 255.0, 0.6) << i;
    }
    EXPECT_EQ(color_of(0.0f), (Code{0, 0, 0}));
}

TEST(ColorMap, NeighboursAreCloseAndFarOnesAreNot)
{
    int most = 0;
    for (int i = 0; i < 255; ++i) {
        const Code a = color_of(static_cast<float>(i) / 255.0f),
                   b = color_of(static_cast<float>(i + 1) / 255.0f);
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max(most, std::abs(a[c] - b[c]));
        EXPECT_NE(a, b) << i;
    }
    EXPECT_LE(most, 8);
}

TEST(ColorMap, WhatIsNoErrorHasTheNearestColour)
{
    EXPECT_EQ(color_of(-1.0f), color_of(0.0f));
    EXPECT_EQ(color_of(7.0f), color_of(1.0f));
    EXPECT_EQ(color_of(std::numeric_limits<float>::infinity()), color_of(1.0f));
    EXPECT_EQ(color_of(std::nanf("")), color_of(0.0f));
}

ErrorMap ramp(int width, int height, float largest)
{
    ErrorMap map{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            map.values.push_back(largest * static_cast<float>(x) /
                                 static_cast<float>(std::max(width - 1, 1)));
    return map;
}

TEST(HeatMap, ShowsEachPixelAndTheBarBelow)
{
    const ErrorMap map = ramp(300, 20, 2.0f);
    const image::CodeImage image = heat_map(map, {"error", 2.0, 1.0});
    EXPECT_EQ(image.width, 300);
    ASSERT_GT(image.height, 20 + 20);
    for (int x = 0; x < 300; ++x)
        EXPECT_EQ(pixel(image, x, 7), color_of(map.values[static_cast<std::size_t>(x)] / 2.0f));
    // Somewhere below stands a row that goes from the first colour to the last.
    bool found = false;
    for (int y = 20; y < image.height; ++y) {
        const auto row = image.bytes.begin() + 3 * 300 * y;
        const Code last = color_of(1.0f);
        const auto end = row + 3 * 300;
        found = found || std::search(row, end, last.begin(), last.end()) != end;
    }
    EXPECT_TRUE(found);
}

TEST(HeatMap, SmallMapsHaveAWholeLegend)
{
    const image::CodeImage image = heat_map(ramp(1, 1, 1.0f), {"absolute error", 1e-12, 1.2345e-13});
    EXPECT_GE(image.width, text_width("absolute error", 1) + text_width("mean 1.23e-13", 1));
    EXPECT_EQ(image.bytes.size(),
              static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 3);
    EXPECT_EQ(pixel(image, 0, 0), color_of(0.0f));
}

TEST(HeatMap, OtherNumbersAreOtherLegends)
{
    const ErrorMap map = ramp(300, 4, 1.0f);
    const image::CodeImage a = heat_map(map, {"error", 1.0, 0.5}), b = heat_map(map, {"error", 1.0, 0.6}),
                           c = heat_map(map, {"terror", 1.0, 0.5});
    EXPECT_NE(a.bytes, b.bytes);
    EXPECT_NE(a.bytes, c.bytes);
}

TEST(HeatMap, TheTopIsRound)
{
    for (const auto& [largest, top] : {std::pair(0.0f, 1.0),
                                       {0.3f, 0.5},
                                       {0.5f, 0.5},
                                       {0.51f, 1.0},
                                       {1234.0f, 2000.0},
                                       {1e-6f, 1e-6},
                                       {1.01e-6f, 2e-6}})
        EXPECT_NEAR(round_top(ramp(5, 1, largest)) / top, 1.0, 1e-9) << largest;
}

TEST(PixelFont, LettersStandWhereTheyShouldAndNowhereElse)
{
    image::CodeImage image{20, 12, 3, 8, std::vector<std::uint8_t>(20 * 12 * 3, 9)};
    draw_text(image, "1", {2, 3, 1}, {200, 100, 50});
    int drawn = 0;
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 20; ++x)
            if (pixel(image, x, y) != Code{9, 9, 9}) {
                EXPECT_EQ(pixel(image, x, y), (Code{200, 100, 50}));
                EXPECT_TRUE(x >= 2 && x < 7 && y >= 3 && y < 10);
                ++drawn;
            }
    EXPECT_GT(drawn, 7);
    EXPECT_EQ(pixel(image, 4, 5), (Code{200, 100, 50})); // its stem
}

TEST(PixelFont, WhatDoesNotFitIsLeftOut)
{
    image::CodeImage image{10, 10, 3, 8, std::vector<std::uint8_t>(300)};
    for (const TextPosition& place : {TextPosition{-8, -5, 2}, {7, 7, 3}, {100, 100, 1}, {-1000, 0, 1}})
        draw_text(image, "FLIP 0.5\xff", place, {1, 2, 3});
    EXPECT_EQ(image.bytes.size(), 300u);
}

TEST(PixelFont, EveryCharacterOfALegendIsItself)
{
    const auto drawn = [](char character) {
        image::CodeImage image{6, 7, 3, 8, std::vector<std::uint8_t>(6 * 7 * 3)};
        draw_text(image, std::string(1, character), {0, 0, 1}, {1, 1, 1});
        return image.bytes;
    };
    const std::string all = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ .-+%:";
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_NE(drawn(all[i]), drawn('\x01')) << all[i];
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_NE(drawn(all[i]), drawn(all[k])) << all[i] << all[k];
    }
    EXPECT_EQ(drawn('e'), drawn('E'));
}

} // namespace
} // namespace lambent::compare
