// How light is shown to FLIP.
#include "compare/flip_exposures.h"
#include "tests/compare/test_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambent::compare {
namespace {

TEST(FlipExposures, DecodingIsTheSrgbCurve)
{
    for (int i = 0; i <= 65535; ++i) {
        const double code = i / 65535.0;
        const double light = code > 0.04045 ? std::pow((code + 0.055) / 1.055, 2.4) : code / 12.92;
        ASSERT_NEAR(decoded(static_cast<float>(code)), light, 1.5e-7) << code;
    }
    EXPECT_EQ(decoded(-1.0f), 0.0f);
    EXPECT_EQ(decoded(2.0f), 1.0f);
}

TEST(FlipExposures, TheCurveIsNarkowiczs)
{
    for (double light = 1e-4; light < 1e4; light *= 1.07) {
        const double x = 0.6 * light;
        const double curve = std::min((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 1.0);
        ASSERT_NEAR(tone_mapped(static_cast<float>(light)), curve, 3e-7 + 3e-7 * curve) << light;
    }
    EXPECT_EQ(tone_mapped(-1.0f), 0.0f);
    EXPECT_EQ(tone_mapped(std::numeric_limits<float>::max()), 1.0f);
    EXPECT_EQ(tone_mapped(std::numeric_limits<float>::infinity()), 1.0f);
}

TEST(FlipExposures, ThePublishedExamplesRangeHasItsNumber)
{
    // NVIDIA's program for reference.exr of its repository: "aces.m12.5423_to_p0.9427.14".
    EXPECT_EQ(exposure_count(-12.5423, 0.9427), 14);
    EXPECT_EQ(exposure_count(0.0, 0.5), 2);
    EXPECT_EQ(exposure_count(1.0, 1.0), 1);
    EXPECT_EQ(exposure_count(-200.0, 200.0), most_exposures);
    const Exposures e{-2.0, 4.0, 4};
    EXPECT_EQ(e.at(0), -2.0);
    EXPECT_EQ(e.at(1), 0.0);
    EXPECT_EQ(e.at(3), 4.0);
}

TEST(FlipExposures, TheyShowTheBrightestAndTheMedianAt85Percent)
{
    image::RadianceImage picture{5, 1, 3, {}};
    for (const float grey : {0.1f, 900.0f, 3.0f, 7.0f, 0.0f})
        picture.values.insert(picture.values.end(), 3, grey);
    const Exposures e = exposures_for(picture);
    EXPECT_NEAR(tone_mapped(static_cast<float>(std::exp2(e.start) * 900.0)), 0.85, 1e-5);
    EXPECT_NEAR(tone_mapped(static_cast<float>(std::exp2(e.stop) * 3.0)), 0.85, 1e-5);
    EXPECT_EQ(e.count, 9); // log2(300) = 8.2
}

TEST(FlipExposures, AnEvenNumberHasItsMedianBetween)
{
    image::RadianceImage picture{4, 1, 3, {}};
    for (const float grey : {8.0f, 1.0f, 4.0f, 2.0f})
        picture.values.insert(picture.values.end(), 3, grey);
    const Exposures e = exposures_for(picture);
    EXPECT_NEAR(e.stop - e.start, std::log2(8.0 / 3.0), 1e-6);
}

TEST(FlipExposures, BlackIsNotDividedBy)
{
    image::RadianceImage picture{5, 1, 3, {}};
    for (const float grey : {0.0f, 0.0f, 0.0f, 16.0f, 2.0f})
        picture.values.insert(picture.values.end(), 3, grey);
    const Exposures mostly_black = exposures_for(picture);
    EXPECT_NEAR(mostly_black.stop - mostly_black.start, std::log2(16.0 / 9.0), 1e-6);

    const Exposures black = exposures_for(test::constant(3, 3, {0.0f, 0.0f, 0.0f}));
    EXPECT_EQ(black.count, 1);
    EXPECT_EQ(black.at(0), 0.0);
    EXPECT_EQ(exposures_for(test::constant(3, 3, {-1.0f, 0.0f, 0.0f})).count, 1);
}

TEST(FlipExposures, ExtremeLightHasFiniteExposures)
{
    for (const float value : {std::numeric_limits<float>::max(), std::numeric_limits<float>::denorm_min()}) {
        const Exposures e = exposures_for(test::constant(2, 2, {value, value, value}));
        EXPECT_TRUE(std::isfinite(e.start) && std::isfinite(e.stop)) << value;
        EXPECT_GE(e.count, 1);
    }
}

} // namespace
} // namespace lambent::compare
