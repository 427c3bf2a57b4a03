// Numbers about one picture, against pictures whose numbers are known.
#include "compare/appearance.h"
#include "compare/brightness_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace lambent::compare {
namespace {

image::CodeImage codes_of(int width, int height, std::array<int, 3> (*code)(int, int))
{
    image::CodeImage image{width, height, 3, 8, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int c : code(x, y))
                image.bytes.push_back(static_cast<std::uint8_t>(c));
    return image;
}

image::RadianceImage light_of(int width, int height,
                              const std::function<std::array<double, 4>(int, int)>& value)
{
    image::RadianceImage image{width, height, 4, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const double v : value(x, y))
                image.values.push_back(static_cast<float>(v));
    return image;
}

std::array<double, 4> grey(double v)
{
    return {v, v, v, 1.0};
}

TEST(Appearance, LooksAreMeansAndSharesOfAllPixels)
{
    const image::CodeImage image = codes_of(4, 1, [](int x, int) {
        return std::array{std::array{255, 250, 252}, std::array{0, 0, 0}, std::array{25, 20, 5},
                          std::array{200, 100, 50}}[static_cast<std::size_t>(x)];
    });
    const Look look = look_of(image);
    EXPECT_NEAR(look.mean, (757.0 + 50.0 + 350.0) / (4.0 * 765.0), 1e-12);
    EXPECT_NEAR(look.saturation, (5.0 / 255.0 + 0.8 + 0.75) / 4.0, 1e-12);
    EXPECT_EQ(look.blank, 0.25);
    EXPECT_EQ(look.black, 0.5);
}

TEST(Appearance, CodesDifferByTheirRootMeanSquare)
{
    const auto three = codes_of(2, 1, [](int x, int) {
        return x == 0 ? std::array{10, 20, 30} : std::array{0, 255, 7};
    });
    const auto other = codes_of(2, 1, [](int x, int) {
        return x == 0 ? std::array{13, 20, 26} : std::array{12, 255, 7};
    });
    EXPECT_NEAR(code_difference(three, other), std::sqrt((9.0 + 16.0 + 144.0) / 6.0) / 255.0, 1e-12);
    EXPECT_EQ(code_difference(three, three), 0.0);
    EXPECT_THROW(code_difference(three, codes_of(1, 1,
                                                 [](int, int) {
                                                     return std::array{0, 0, 0};
                                                 })),
                 std::invalid_argument);
}

TEST(Appearance, LuminanceIsWhatAnSrgbDisplayShows)
{
    // Half white, half the code 188, which is 0.5029 of white [IEC 61966-2-1: ((188/255 + 0.055) / 1.055)^2.4].
    const image::CodeImage image = codes_of(8, 4, [](int x, int) {
        return x < 4 ? std::array{255, 255, 255} : std::array{188, 188, 188};
    });
    EXPECT_NEAR(displayed_luminance(image), 0.5 * (1.0 + std::pow((188.0 / 255.0 + 0.055) / 1.055, 2.4)),
                1e-12);
    EXPECT_NEAR(displayed_luminance(codes_of(2, 2,
                                             [](int, int) {
                                                 return std::array{0, 255, 0};
                                             })),
                0.7152, 1e-12);
}

TEST(Appearance, SaturationCountsCoveredPixelsOnly)
{
    const image::CodeImage image = codes_of(4, 1, [](int x, int) {
        return x == 0 ? std::array{200, 100, 50} : x == 1 ? std::array{0, 0, 0} : std::array{255, 0, 0};
    });
    const image::RadianceImage light = light_of(4, 1, [](int x, int) {
        return std::array{1.0, 1.0, 1.0, x < 2 ? 1.0 : 0.5};
    });
    EXPECT_NEAR(mean_saturation(image, light), 0.5 * 0.75, 1e-12);
}

TEST(Appearance, AReversedOrderOfChannelsIsFoundAndATieIsNone)
{
    // Ten pixels, so that only the brightest counts.
    const image::RadianceImage light = light_of(10, 1, [](int x, int) {
        return x == 3 ? std::array{9.0, 8.0, 7.0, 1.0} : grey(0.1);
    });
    const auto judged = [&](std::array<int, 3> (*code)(int, int)) {
        return kept_hue_order(codes_of(10, 1, code), light);
    };
    EXPECT_EQ(judged([](int, int) { return std::array{3, 2, 1}; }), 1.0);
    EXPECT_EQ(judged([](int, int) { return std::array{255, 255, 255}; }), 1.0);
    EXPECT_EQ(judged([](int, int) { return std::array{3, 1, 2}; }), 0.0);
}

TEST(Appearance, SpreadIsDeviationOverMean)
{
    EXPECT_NEAR(luminance_spread(light_of(4, 4, [](int, int) { return grey(3.0); })), 0.0, 1e-6);
    // 1 and 3: mean 2, deviation 1. What is not covered does not count.
    const auto half = [](int x, int y) {
        return y > 2 ? std::array{9.0, 9.0, 9.0, 0.0} : grey(x % 2 == 0 ? 1.0 : 3.0);
    };
    EXPECT_NEAR(luminance_spread(light_of(4, 4, half)), 0.5, 1e-6);
    EXPECT_EQ(luminance_spread(light_of(4, 4, [](int, int) { return grey(0.0); })), 0.0);
}

TEST(Appearance, FineDifferenceSeesStripesAndNotBrightness)
{
    const image::RadianceImage flat = light_of(64, 64, [](int, int) { return grey(2.0); });
    const image::RadianceImage brighter = light_of(64, 64, [](int, int) { return grey(2.5); });
    EXPECT_NEAR(fine_difference(brighter, flat), 0.0, 1e-6);
    // Stripes of +-0.2 every pixel: 10 % of the mean, but for the 17 x 17 window's odd column.
    const image::RadianceImage striped =
        light_of(64, 64, [](int x, int) { return grey(x % 2 == 0 ? 2.2 : 1.8); });
    EXPECT_NEAR(fine_difference(striped, flat), 0.1, 0.01);
    // A slope is no structure of a few pixels, but for where the window is cut at the borders.
    const image::RadianceImage slope = light_of(64, 64, [](int x, int) { return grey(2.0 + 0.01 * x); });
    EXPECT_LT(fine_difference(slope, flat), 0.012);
}

TEST(Appearance, PicturesOfDifferentSizeAreRefused)
{
    const image::RadianceImage a = light_of(4, 4, [](int, int) { return grey(1.0); }),
                               b = light_of(4, 3, [](int, int) { return grey(1.0); });
    EXPECT_THROW(fine_difference(a, b), std::invalid_argument);
    EXPECT_THROW(brightness_fit({a, b}), std::invalid_argument);
    EXPECT_THROW(mean_saturation(codes_of(2, 2,
                                          [](int, int) {
                                              return std::array{0, 0, 0};
                                          }),
                                 a),
                 std::invalid_argument);
}

TEST(BrightnessFit, OneFactorExplainsADarkerPicture)
{
    const auto value = [](int x, int y) { return 0.5 + 0.1 * ((3 * x + 5 * y) % 7); };
    const image::RadianceImage reference = light_of(16, 16, [&](int x, int y) { return grey(value(x, y)); });
    const image::RadianceImage darker =
        light_of(16, 16, [&](int x, int y) { return grey(0.25 * value(x, y)); });
    const BrightnessFit fit = brightness_fit({darker, reference});
    EXPECT_NEAR(fit.factor, 4.0, 1e-5);
    EXPECT_NEAR(fit.left, 0.0, 1e-3);
    double squares = 0.0, sum = 0.0;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            squares += std::pow(0.75 * value(x, y), 2.0);
            sum += value(x, y);
        }
    EXPECT_NEAR(fit.error, std::sqrt(squares * 256.0) / sum, 1e-5);
}

TEST(BrightnessFit, WhatIsNotCoveredDoesNotCount)
{
    const image::RadianceImage reference = light_of(4, 1, [](int, int) { return grey(1.0); });
    const image::RadianceImage picture = light_of(4, 1, [](int x, int) {
        return x < 2 ? grey(1.0) : std::array{9.0, 9.0, 9.0, 0.9};
    });
    EXPECT_NEAR(brightness_fit({picture, reference}).error, 0.0, 1e-6);
    const image::RadianceImage none = light_of(4, 1, [](int, int) { return std::array{1.0, 1.0, 1.0, 0.0}; });
    EXPECT_EQ(brightness_fit({none, reference}).factor, 0.0);
}

} // namespace
} // namespace lambent::compare
