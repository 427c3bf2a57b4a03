// Heat maps: colours that can be read as amounts, and a legend.
#include "compare/heat_map.h"

#include "compare/pixel_font.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lambent::compare {
namespace {

// Luma of Rec. 601, by which the map's author made it even.
double luma(const HeatColor& c)
{
    return (0.30 * c.r + 0.59 * c.g + 0.11 * c.b) / 255.0;
}

TEST(HeatMap, BrightnessIsTheValue)
{
    for (int i = 0; i <= 100; ++i)
        EXPECT_NEAR(luma(heat_color(static_cast<float>(i) / 100.0f)), i / 100.0, 0.03) << i;
    EXPECT_EQ(luma(heat_color(-1.0f)), 0.0);
    EXPECT_NEAR(luma(heat_color(2.0f)), 1.0, 1e-9);
}

TEST(HeatMap, ShowsTheValuesAboveALegend)
{
    Plane plane(64, 32);
    plane.row(3)[7] = 2.0f;
    const image::CodeImage map = heat_map(plane, {"test", 2.0f, 0.1});
    EXPECT_EQ(map.width, 64);
    ASSERT_GT(map.height, 32 + 2 * glyph_height);
    EXPECT_EQ(map.bytes[3 * (3 * 64 + 7)], 255);
    EXPECT_EQ(map.bytes[3 * (3 * 64 + 8)], 0);
    // Something is written below.
    const auto legend = map.bytes.begin() + 3 * 64 * 45;
    EXPECT_GT(std::count(legend, map.bytes.end(), 255), 50);
}

TEST(HeatMap, OfATinyPictureIsNoTrouble)
{
    EXPECT_EQ(heat_map(Plane(1, 1), {"test", 1.0f, 0.0}).width, 1);
}

TEST(HeatMap, DifferencesAreTheLargestOfTheChannels)
{
    const image::RadianceImage a{1, 1, 3, {1.0f, 2.0f, 3.0f}}, b{1, 1, 3, {1.0f, 1.0f, 1.0f}};
    EXPECT_FLOAT_EQ(absolute_difference(a, b).values[0], 2.0f);
    EXPECT_FLOAT_EQ(relative_difference(a, b).values[0], 2.0f / 1.01f);
}

TEST(PixelFont, WritesWhatItIsAsked)
{
    image::CodeImage image{20, 10, 3, 8, std::vector<std::uint8_t>(600, 0)};
    EXPECT_EQ(write_text(image, {1, 1, 1}, "1I"), 13);
    // The foot of the 1: three pixels at the bottom.
    EXPECT_EQ(image.bytes[3 * (7 * 20 + 2)], 255);
    EXPECT_EQ(image.bytes[3 * (7 * 20 + 1)], 0);
    image::CodeImage small = image;
    EXPECT_EQ(write_text(small, {-30, -30, 3}, "88"), 6); // outside: nothing happens
    EXPECT_EQ(small.bytes, image.bytes);
}

} // namespace
} // namespace lambent::compare
