// Errors that need no eyes, by hand.
#include "compare/difference.h"
#include "tests/compare/test_pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace lambent::compare {
namespace {

using image::RadianceImage;
using test::constant;

TEST(Difference, ByHand)
{
    // Differences 1, 0, 2 and 0, 0, -3: squares 14 over 6 values; the reference's mean is 11 / 6.
    const RadianceImage a{2, 1, 3, {2, 2, 4, 1, 2, 0}}, b{2, 1, 3, {1, 2, 2, 1, 2, 3}};
    const Difference d = difference({a, b}, 10.0);
    EXPECT_NEAR(d.rmse, std::sqrt(14.0 / 6.0), 1e-12);
    EXPECT_NEAR(d.relative_rmse, std::sqrt(14.0 / 6.0) / (11.0 / 6.0), 1e-12);
    EXPECT_NEAR(d.psnr, 10.0 * std::log10(100.0 / (14.0 / 6.0)), 1e-9);
    EXPECT_EQ(d.max, 3.0);
    EXPECT_EQ(largest_value(b), 3.0);
}

TEST(Difference, OnlyCoveredPixelsCount)
{
    const RadianceImage a{2, 1, 3, {2, 2, 4, 1, 2, 0}}, b{2, 1, 3, {1, 2, 2, 1, 2, 3}};
    const std::vector<char> second = {0, 1};
    const Pair pair{a, b, second};
    EXPECT_EQ(pixel_count(pair), 1u);
    EXPECT_NEAR(difference(pair, 1.0).rmse, std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(difference(pair, 1.0).relative_rmse, std::sqrt(3.0) / 2.0, 1e-12);
    EXPECT_EQ(mean({2, 1, {0.25f, 0.75f}}, pair), 0.75);
    EXPECT_EQ(mean({2, 1, {0.25f, 0.75f}}, {a, b}), 0.5);
    const std::vector<char> three = {0, 1, 1};
    EXPECT_THROW(difference({a, b, three}, 1.0), std::invalid_argument);
}

TEST(Difference, ASineOverWholePeriodsHasItsClosedForm)
{
    RadianceImage a = constant(64, 64, {0.5f, 0.5f, 0.5f});
    const RadianceImage b = a;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            for (int c = 0; c < 3; ++c)
                a.pixel(x, y)[c] += static_cast<float>(0.25 * std::sin(2.0 * std::numbers::pi * x / 16.0));
    const Difference d = difference({a, b}, 1.0);
    EXPECT_NEAR(d.rmse, 0.25 / std::numbers::sqrt2, 1e-7);
    EXPECT_NEAR(d.relative_rmse, 0.5 / std::numbers::sqrt2, 1e-7);
    EXPECT_NEAR(d.psnr, -20.0 * std::log10(0.25 / std::numbers::sqrt2), 1e-6);
    EXPECT_NEAR(d.max, 0.25, 1e-7);
}

TEST(Difference, CoverageDoesNotCount)
{
    const RadianceImage a{1, 1, 4, {1, 2, 3, 0}}, b{1, 1, 4, {1, 2, 3, 1}}, c{1, 1, 3, {1, 2, 3}};
    EXPECT_EQ(difference({a, b}, 1.0).rmse, 0.0);
    EXPECT_EQ(difference({a, c}, 1.0).max, 0.0);
}

TEST(Difference, EqualAndBlackPicturesHaveTheirLimits)
{
    const RadianceImage black = constant(2, 2, {0, 0, 0}), white = constant(2, 2, {1, 1, 1});
    EXPECT_TRUE(std::isinf(difference({white, white}, 1.0).psnr));
    EXPECT_EQ(difference({black, black}, 1.0).relative_rmse, 0.0);
    EXPECT_TRUE(std::isinf(difference({white, black}, 1.0).relative_rmse));
    EXPECT_EQ(difference({white, black}, 1.0).psnr, 0.0);
}

TEST(Difference, HugeLightDoesNotOverflow)
{
    const RadianceImage a = constant(4, 4, {3e38f, 0, 0}), b = constant(4, 4, {-3e38f, 0, 0});
    EXPECT_NEAR(difference({a, b}, 1.0).max / 6e38, 1.0, 1e-6);
    EXPECT_NEAR(difference({a, b}, 1.0).rmse / (6e38 / std::sqrt(3.0)), 1.0, 1e-6);
}

TEST(Difference, MapsAreTheErrorOfEachPixel)
{
    const RadianceImage a{2, 1, 3, {3, 0, 0, 1, 1, 1}}, b{2, 1, 3, {0, 0, 0, 2, 2, 2}};
    const ErrorMap absolute = absolute_error({a, b}), relative = relative_error({a, b});
    EXPECT_NEAR(absolute.values[0], std::sqrt(3.0), 1e-6);
    EXPECT_NEAR(absolute.values[1], 1.0, 1e-6);
    // The mean of all is 1, of which a hundredth is added.
    EXPECT_NEAR(relative.values[0], std::sqrt(3.0) / 0.01, 1e-3);
    EXPECT_NEAR(relative.values[1], 1.0 / 2.01, 1e-6);
    EXPECT_NEAR(mean(absolute), (1.0 + std::sqrt(3.0)) / 2.0, 1e-6);
}

TEST(Difference, RegionsCountAlikeWhateverTheirSizeAndLight)
{
    // Region 7: one pixel, off by half. Region 2: three pixels, off by a tenth. One pixel of no region, far off; one
    // region without light.
    const RadianceImage a{
        6, 1, 3, {0.3f, 0.3f, 0.3f, 0.9f, 0.9f, 0.9f, 0.9f, 0.9f, 0.9f, 0.9f, 0.9f, 0.9f, 0, 0, 0, 1, 1, 1}};
    const RadianceImage b{6, 1, 3, {0.2f, 0.2f, 0.2f, 1, 1, 1, 5, 5, 5, 1, 1, 1, 1, 1, 1, 0, 0, 0}};
    const std::vector<int> labels = {7, 2, 2, 2, -1, 3};
    const RegionError error = region_error({a, b}, labels);
    EXPECT_EQ(error.regions, 2);
    EXPECT_NEAR(error.mean, 0.3, 1e-6);
    EXPECT_NEAR(error.largest, 0.5, 1e-6);
    EXPECT_GT(region_error({a, b}, labels, 10.0f).mean, 0.5);
    EXPECT_EQ(region_error({b, b}, labels).mean, 0.0);
}

TEST(Difference, RefusesWhatDoesNotFit)
{
    const RadianceImage a = constant(2, 3, {0, 0, 0}), b = constant(3, 2, {0, 0, 0});
    EXPECT_THROW(difference({a, b}, 1.0), std::invalid_argument);
    EXPECT_THROW(absolute_error({a, b}), std::invalid_argument);
    EXPECT_THROW(region_error({a, a}, std::vector<int>(5)), std::invalid_argument);
}

} // namespace
} // namespace lambent::compare
