// FLIP against the papers' formulas written a second time, and against what can be worked out by hand.
#include "compare/flip.h"

#include "tests/compare/naive_flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lambent::compare {
namespace {

image::RadianceImage filled(int width, int height, float r, float g, float b)
{
    image::RadianceImage image{width, height, 3, {}};
    for (int i = 0; i < width * height; ++i)
        image.values.insert(image.values.end(), {r, g, b});
    return image;
}

// Soft gradients, hard edges, points and noise in one.
image::RadianceImage busy(unsigned seed, float scale = 1.0f)
{
    image::RadianceImage image = filled(45, 31, 0.0f, 0.0f, 0.0f);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c)
                image.pixel(x, y)[c] = scale *
                                       ((x > 20) == (c == 1) ? 0.7f : 0.2f * static_cast<float>(y) / 31.0f) *
                                       uniform(random);
    image.pixel(5, 5)[0] = scale;
    return image;
}

TEST(Flip, EqualPicturesDoNotDiffer)
{
    EXPECT_EQ(mean(flip(busy(1), busy(1))), 0.0);
    EXPECT_EQ(mean(hdr_flip(busy(1, 50.0f), busy(1, 50.0f))), 0.0);
}

TEST(Flip, IsWhatThePaperSays)
{
    for (double ppd : {67.0, 20.0, 33.5}) {
        const image::RadianceImage a = busy(1), b = busy(2);
        const Plane ours = flip(a, b, ppd);
        const std::vector<double> naive = testing::naive_flip(a, b, ppd);
        double largest = 0.0;
        for (std::size_t i = 0; i < naive.size(); ++i) {
            EXPECT_NEAR(static_cast<double>(ours.values[i]), naive[i], 2e-4) << "pixel " << i << ", " << ppd;
            largest = std::max(largest, naive[i]);
        }
        EXPECT_GT(largest, 0.2);
    }
}

// By hand: L goes from 0 to 100, chroma is 0; HyAB = 100, 100^0.7 = 25.1. Green and blue are 41.3 apart, 0.4 of that is
// 16.5; so 0.95 + 0.05 (25.1 - 16.5) / (41.3 - 16.5) = 0.967. No edges.
TEST(Flip, BlackAgainstWhite)
{
    const image::RadianceImage black = filled(24, 16, 0.0f, 0.0f, 0.0f),
                               white = filled(24, 16, 1.0f, 1.0f, 1.0f);
    EXPECT_NEAR(mean(flip(black, white)), 0.9673, 5e-4);
    EXPECT_NEAR(mean(flip(white, black)), 0.9673, 5e-4);
}

TEST(Flip, GreenAgainstBlueIsTheMost)
{
    EXPECT_NEAR(mean(flip(filled(24, 16, 0.0f, 1.0f, 0.0f), filled(24, 16, 0.0f, 0.0f, 1.0f))), 1.0, 1e-4);
}

TEST(Flip, GrowsWithTheDifferenceAndWithNearness)
{
    const image::RadianceImage reference = filled(32, 32, 0.5f, 0.5f, 0.5f);
    double before = 0.0;
    for (float off : {0.01f, 0.05f, 0.1f, 0.3f}) {
        const double now = mean(flip(filled(32, 32, 0.5f + off, 0.5f, 0.5f), reference));
        EXPECT_GT(now, before);
        before = now;
    }
    // A chequerboard is seen from near and is grey from afar.
    image::RadianceImage board = reference;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
            for (int c = 0; c < 3; ++c)
                board.pixel(x, y)[c] = (x + y) % 2 == 0 ? 0.4f : 0.6f;
    EXPECT_GT(mean(flip(board, reference, 20.0)), 2.0 * mean(flip(board, reference, 120.0)));
}

// The curve shows 0.85 where (0.9036 x^2 + 0.018 x) / (0.8748 x^2 + 0.354 x + 0.14) = 0.85: at x = 2.119.
TEST(HdrFlip, ExposuresShowTheBrightestAndTheMedianAlike)
{
    image::RadianceImage image = filled(10, 10, 1.0f, 1.0f, 1.0f);
    for (int c = 0; c < 3; ++c)
        image.pixel(3, 3)[c] = 256.0f;
    const Exposures e = exposures_for(image);
    EXPECT_NEAR(e.stop, std::log2(2.118872), 1e-5);
    EXPECT_NEAR(e.start, e.stop - 8.0, 1e-9);
    EXPECT_EQ(e.count, 8);
    EXPECT_EQ(exposures_for(filled(4, 4, 1.0f, 1.0f, 1.0f)).count, 2);
    EXPECT_TRUE(std::isfinite(exposures_for(filled(4, 4, 0.0f, 0.0f, 0.0f)).stop));
}

// Shown at one exposure, it is FLIP of the toned pictures: the tone curve is written out here once more.
TEST(HdrFlip, OfOneBrightnessIsFlipOfWhatIsShown)
{
    const float light = 3.0f, other = 2.0f;
    const double factor = std::exp2(exposures_for(filled(16, 16, light, light, light)).start);
    const auto shown = [factor](float v) {
        const double x = 0.6 * factor * static_cast<double>(v);
        return static_cast<float>(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14));
    };
    const float a = shown(other), b = shown(light);
    EXPECT_NEAR(static_cast<double>(b), 0.85, 1e-6);
    EXPECT_NEAR(mean(hdr_flip(filled(16, 16, other, other, other), filled(16, 16, light, light, light))),
                mean(flip(filled(16, 16, a, a, a), filled(16, 16, b, b, b))), 1e-5);
}

TEST(HdrFlip, DoesNotDependOnTheUnitOfLight)
{
    const double one = mean(hdr_flip(busy(1, 1.0f), busy(2, 1.0f)));
    const double thousand = mean(hdr_flip(busy(1, 1000.0f), busy(2, 1000.0f)));
    EXPECT_NEAR(one, thousand, 1e-4);
    EXPECT_GT(one, 0.05);
}

} // namespace
} // namespace lambent::compare
