// FLIP against a second implementation, the authors' own program's numbers, and what its definition says by hand.
#include "compare/flip.h"
#include "tests/compare/naive_flip.h"
#include "tests/compare/test_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lambent::compare {
namespace {

using image::RadianceImage;
using test::bright_waves;
using test::constant;
using test::waves;

double at(const ErrorMap& map, int x, int y)
{
    return static_cast<double>(map.values[static_cast<std::size_t>(y * map.width + x)]);
}

// Features enter by a square root, at which a float's last bit can be seen in the third digit.
constexpr double pixel_tolerance = 1e-4, mean_tolerance = 1e-6;

void expect_near(const ErrorMap& map, const std::vector<double>& errors)
{
    ASSERT_EQ(map.values.size(), errors.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        sum += errors[i];
        ASSERT_NEAR(map.values[i], errors[i], pixel_tolerance) << i;
    }
    EXPECT_NEAR(mean(map), sum / static_cast<double>(errors.size()), mean_tolerance);
}

TEST(Flip, AgreesWithTheNaiveImplementation)
{
    const RadianceImage a = waves(70, 45, 0.3), b = waves(70, 45, 0.0);
    for (const double ppd : {67.0, 25.0, 3.0})
        expect_near(ldr_flip({a, b}, {ppd, {}}), test::naive_ldr_flip(a, b, ppd));
}

TEST(Flip, AgreesWithTheNaiveImplementationAcrossTiles)
{
    // Wider and higher than a tile, by a part of one; thin, for the naive one takes its time.
    for (const auto& [width, height] : {std::pair(300, 9), std::pair(7, 140)}) {
        const RadianceImage a = waves(width, height, 0.2), b = waves(width, height, 0.0);
        expect_near(ldr_flip({a, b}, {40.0, {}}), test::naive_ldr_flip(a, b, 40.0));
    }
}

TEST(Flip, HdrAgreesWithTheNaiveImplementation)
{
    const RadianceImage a = bright_waves(40, 30, 0.3), b = bright_waves(40, 30, 0.0);
    expect_near(hdr_flip({a, b}).map, test::naive_hdr_flip(a, b, 67.0));
}

// What the formulas of NVIDIA's Python program (flip_api.py of the FLIP repository, 2021) give for these pictures in
// numpy's doubles: mean, and the pixels (11, 7), (0, 0) and (47, 35).
TEST(Flip, AgreesWithTheAuthorsProgram)
{
    const RadianceImage a = waves(48, 36, 0.3), b = waves(48, 36, 0.0);
    struct Published {
        double ppd, mean, inside, first, last;
    };
    for (const Published& p : {Published{67.0, 0.439236950, 0.510586989, 0.584035033, 0.149035426},
                               {30.0, 0.437450946, 0.464900048, 0.543176115, 0.158677289},
                               {5.0, 0.442277658, 0.457391683, 0.525793985, 0.166516713}}) {
        const ErrorMap map = ldr_flip({a, b}, {p.ppd, {}});
        EXPECT_NEAR(mean(map), p.mean, mean_tolerance);
        EXPECT_NEAR(at(map, 11, 7), p.inside, pixel_tolerance);
        EXPECT_NEAR(at(map, 0, 0), p.first, pixel_tolerance);
        EXPECT_NEAR(at(map, 47, 35), p.last, pixel_tolerance);
    }
}

TEST(Flip, HdrAgreesWithTheAuthorsProgram)
{
    const RadianceImage a = bright_waves(48, 36, 0.3), b = bright_waves(48, 36, 0.0);
    const HdrFlip flip = hdr_flip({a, b});
    EXPECT_NEAR(flip.exposures.start, -3.473775672, 1e-5);
    EXPECT_NEAR(flip.exposures.stop, -0.956035531, 1e-5);
    EXPECT_EQ(flip.exposures.count, 3);
    EXPECT_NEAR(mean(flip.map), 0.596366338, mean_tolerance);
    EXPECT_NEAR(at(flip.map, 11, 7), 0.568104380, pixel_tolerance);
    EXPECT_NEAR(at(flip.map, 0, 0), 0.963896639, pixel_tolerance);
}

// Black is L* = 0, white 100, both without colour: HyAB is 100, its power 100^0.7 = 25.1189. Green against blue has
// 41.2761, of which 0.4 is 16.5104. So 0.95 + 0.05 (25.1189 - 16.5104) / (41.2761 - 16.5104) = 0.967380.
TEST(Flip, BlackAgainstWhiteByHand)
{
    const RadianceImage black = constant(4, 3, {0.0f, 0.0f, 0.0f}),
                        white = constant(4, 3, {1.0f, 1.0f, 1.0f});
    for (const float error : ldr_flip({black, white}).values)
        EXPECT_NEAR(error, 0.967380, 2e-6);
}

TEST(Flip, EvenColoursAsTheAuthorsProgram)
{
    struct Case {
        float a[3], b[3];
        double error;
    };
    for (const Case& c : {Case{{1, 0, 0}, {0, 1, 0}, 0.986662275},
                          {{0, 0, 1}, {0, 1, 0}, 1.0},
                          {{0.5f, 0.5f, 0.5f}, {0.6f, 0.5f, 0.5f}, 0.249604392},
                          {{0.5f, 0.5f, 0.5f}, {0.502f, 0.5f, 0.498f}, 0.019804514}})
        EXPECT_NEAR(mean(ldr_flip({constant(5, 5, c.a), constant(5, 5, c.b)})), c.error, 5e-6);
}

TEST(Flip, EqualPicturesHaveNoError)
{
    const RadianceImage codes = waves(30, 20, 0.0), light = bright_waves(30, 20, 0.0);
    EXPECT_EQ(mean(ldr_flip({codes, codes})), 0.0);
    EXPECT_EQ(mean(hdr_flip({light, light}).map), 0.0);
    const RadianceImage black = constant(3, 3, {0.0f, 0.0f, 0.0f});
    EXPECT_EQ(mean(hdr_flip({black, black}).map), 0.0);
}

TEST(Flip, LdrIsSymmetric)
{
    const RadianceImage a = waves(30, 20, 0.4), b = waves(30, 20, 0.0);
    EXPECT_EQ(ldr_flip({a, b}).values, ldr_flip({b, a}).values);
}

TEST(Flip, MoreDifferenceIsMoreError)
{
    const RadianceImage grey = constant(6, 6, {0.4f, 0.4f, 0.4f});
    double last = 0.0;
    for (float step = 0.01f; step < 0.6f; step *= 1.3f) {
        const double error = mean(ldr_flip({constant(6, 6, {0.4f + step, 0.4f + step, 0.4f}), grey}));
        EXPECT_GT(error, last) << step;
        last = error;
    }
    EXPECT_LE(last, 1.0);
}

TEST(Flip, ACrispErrorCountsForMoreThanASmoothOne)
{
    // The same change of a colour, once with a border inside the picture.
    RadianceImage half = constant(40, 40, {0.5f, 0.5f, 0.5f});
    for (std::size_t i = 0; i < half.values.size() / 2; ++i)
        half.values[i] = 0.55f;
    const RadianceImage grey = constant(40, 40, {0.5f, 0.5f, 0.5f});
    const ErrorMap map = ldr_flip({half, grey});
    const double far_from_it = at(map, 20, 2), beside = at(map, 20, 18);
    const double without = mean(ldr_flip({constant(40, 40, {0.55f, 0.55f, 0.55f}), grey}));
    EXPECT_NEAR(far_from_it, without, 1e-4);
    EXPECT_GT(beside, 1.1 * far_from_it);
    EXPECT_LT(at(map, 20, 38), 1e-3);
}

TEST(Flip, HdrIsTheSameAtAnyScale)
{
    RadianceImage a = bright_waves(30, 20, 0.3), b = bright_waves(30, 20, 0.0);
    const double error = mean(hdr_flip({a, b}).map);
    for (RadianceImage* picture : {&a, &b})
        for (float& value : picture->values)
            value *= 4096.0f;
    EXPECT_NEAR(mean(hdr_flip({a, b}).map), error, 1e-6);
}

TEST(Flip, LightThatIsNoLightIsBounded)
{
    const float most = 3.0e38f;
    for (const RadianceImage& a : {constant(4, 4, {most, -most, 1e-45f}), constant(4, 4, {0.0f, 0.0f, 0.0f})})
        for (const RadianceImage& b :
             {constant(4, 4, {1e-45f, 1e-45f, 1e-45f}), constant(4, 4, {most, most, most})})
            for (const float error : hdr_flip({a, b}).map.values) {
                EXPECT_GE(error, 0.0f);
                EXPECT_LE(error, 1.0f);
            }
}

TEST(Flip, TellsItsProgress)
{
    const RadianceImage a = waves(600, 200, 0.1), b = waves(600, 200, 0.0);
    std::vector<float> told;
    ldr_flip({a, b}, {67.0, [&](float done) { told.push_back(done); }});
    ASSERT_EQ(told.size(), 6u);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_EQ(told.back(), 1.0f);
}

TEST(Flip, RefusesPicturesOfDifferentSize)
{
    const RadianceImage a = waves(8, 4, 0.0), b = waves(4, 8, 0.0);
    EXPECT_THROW(ldr_flip({a, b}), std::invalid_argument);
    EXPECT_THROW(hdr_flip({a, b}), std::invalid_argument);
}

} // namespace
} // namespace lambent::compare
