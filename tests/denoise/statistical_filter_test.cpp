// The statistical filter against pictures whose truth is known: noise that it takes away, and what it leaves alone.
#include "denoise/statistical_filter.h"

#include "base/error.h"
#include "tests/support/each_instruction_set.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <random>

namespace lambent::denoise::test {
namespace {

class StatisticalFilter : public lambent::test::EachInstructionSet {};
LAMBENT_EACH_INSTRUCTION_SET(StatisticalFilter);

constexpr int columns = 150, rows = 70;

using Truth = std::function<double(int x, int y)>;

// Light that falls on a wall seen from the front, five metres away.
NoisyPicture make_lit_wall()
{
    constexpr std::size_t size = static_cast<std::size_t>(columns) * rows;
    const auto filled = [](float value) {
        return Rgb{Plane(size, value), Plane(size, value), Plane(size, value)};
    };
    NoisyPicture picture{columns,      rows,         filled(0.0f), filled(0.0f), Plane(size, 7.0f),
                         filled(0.0f), filled(1.0f), {},           filled(0.0f), Plane(size, 5.0f)};
    picture.coverage = picture.normal[2] = Plane(size, 1.0f);
    return picture;
}

std::size_t place(int x, int y)
{
    return static_cast<std::size_t>(y * columns + x);
}

// Means and variances of `count` samples of truth times albedo, plus emitted light. The channels have the same noise, as
// that of white light has. `sample` gives a sample of 1.
void trace(NoisyPicture& picture, const Truth& truth, int count,
           const std::function<double(std::mt19937&)>& sample, unsigned seed = 1)
{
    std::mt19937 random(seed);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const std::size_t i = place(x, y);
            double sum = 0.0, squares = 0.0;
            for (int k = 0; k < count; ++k) {
                const double value = truth(x, y) * sample(random);
                sum += value / count;
                squares += value * value / count;
            }
            picture.freedom[i] = static_cast<float>(count - 1);
            for (std::size_t c = 0; c < 3; ++c) {
                const double albedo = static_cast<double>(picture.albedo[c][i]);
                picture.light[c][i] = picture.emitted[c][i] + static_cast<float>(albedo * sum);
                picture.variance[c][i] =
                    count > 1 ? static_cast<float>(albedo * albedo * std::max(squares - sum * sum, 0.0) /
                                                   (count - 1))
                              : std::numeric_limits<float>::infinity();
            }
        }
}

std::function<double(std::mt19937&)> normal_noise(double deviation)
{
    return [=](std::mt19937& random) { return std::normal_distribution<double>(1.0, deviation)(random); };
}

// Root mean square difference from the truth, of the columns from `first` to `last`.
double error_of(const NoisyPicture& picture, const Rgb& light, const Truth& truth, int first = 0,
                int last = columns)
{
    double sum = 0.0;
    for (int y = 0; y < rows; ++y)
        for (int x = first; x < last; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t i = place(x, y);
                const double expected = static_cast<double>(picture.emitted[c][i]) +
                                        static_cast<double>(picture.albedo[c][i]) * truth(x, y);
                sum += std::pow(static_cast<double>(light[c][i]) - expected, 2);
            }
    return std::sqrt(sum / (3.0 * rows * (last - first)));
}

double one(int, int)
{
    return 1.0;
}

// An average of all 225 pixels in its weights would leave 0.078 of the noise: the root of the sum of squared weights.
// Half as much again is lost to tests that fail by chance, and to the noise of the variances.
TEST_P(StatisticalFilter, EqualLightLosesItsNoise)
{
    for (const int count : {8, 2, 1}) {
        NoisyPicture picture = make_lit_wall();
        trace(picture, one, count, normal_noise(0.2));
        const double before = error_of(picture, picture.light, one),
                     after = error_of(picture, filter_statistically(picture), one);
        std::printf("equal light, %d samples: noise %.4f, filtered %.4f\n", count, before, after);
        EXPECT_NEAR(before, 0.2 / std::sqrt(count), 0.01 * before);
        EXPECT_LT(after, (count == 8 ? 0.16 : 0.3) * before);
    }
}

// Only a step in the light, of 8 deviations of a pixel's noise: guides are the same on both sides.
TEST_P(StatisticalFilter, AStepOfManyDeviationsStays)
{
    const Truth step = [](int x, int) { return x < columns / 2 ? 0.5 : 1.0; };
    NoisyPicture picture = make_lit_wall();
    trace(picture, step, 16, normal_noise(0.25));
    const Rgb filtered = filter_statistically(picture);
    const double noise = 0.75 * 0.25 / 4.0;
    EXPECT_LT(error_of(picture, filtered, step, columns / 2 - 1, columns / 2 + 1), noise);
    EXPECT_LT(error_of(picture, filtered, step), 0.4 * noise);
}

// Light divided by the albedo is equal; a texture of the albedo is not blurred.
TEST_P(StatisticalFilter, TexturesStayAndLoseTheirNoise)
{
    NoisyPicture picture = make_lit_wall();
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                picture.albedo[c][place(x, y)] = (x / 2 + y / 2) % 2 ? 0.9f : 0.1f;
    trace(picture, one, 8, normal_noise(0.2));
    const Rgb filtered = filter_statistically(picture);
    EXPECT_LT(error_of(picture, filtered, one), 0.2 * error_of(picture, picture.light, one));
    for (int x = 4; x + 4 < columns; ++x)
        EXPECT_NEAR(filtered[1][place(x, 30)] / picture.albedo[1][place(x, 30)], 1.0, 0.1);
}

// As in a mirror: light that varies from pixel to pixel and has next to no noise.
TEST_P(StatisticalFilter, LightWithoutNoiseStays)
{
    const Truth mirrored = [](int x, int y) { return 1.0 + 0.5 * std::sin(0.7 * x) * std::cos(0.9 * y); };
    NoisyPicture picture = make_lit_wall();
    trace(picture, mirrored, 8, normal_noise(1e-5));
    EXPECT_LT(error_of(picture, filter_statistically(picture), mirrored), 2e-5);
}

// A background, or a surface that shines: not reflected, and the same to the last digit.
TEST_P(StatisticalFilter, WhatIsNotReflectedStaysAsItIs)
{
    NoisyPicture picture = make_lit_wall();
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < 50; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                picture.albedo[c][place(x, y)] = 0.0f;
                picture.emitted[c][place(x, y)] = static_cast<float>((7 * x + 3 * y) % 11);
            }
    trace(picture, one, 8, normal_noise(0.3));
    const Rgb filtered = filter_statistically(picture);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < 50; ++x)
            EXPECT_EQ(filtered[0][place(x, y)], picture.light[0][place(x, y)]);
    EXPECT_LT(error_of(picture, filtered, one, 50), 0.2 * 0.3 / std::sqrt(8.0));
}

// Light of one surface has no part in that of another whose normal, or distance, is another. Three pixels from the edge
// not even in how much is averaged.
TEST_P(StatisticalFilter, NothingLeaksFromOneSurfaceToAnother)
{
    for (const bool turned : {false, true}) {
        NoisyPicture picture = make_lit_wall();
        for (int y = 0; y < rows; ++y)
            for (int x = 70; x < columns; ++x) {
                picture.normal[0][place(x, y)] = turned ? 1.0f : 0.0f;
                picture.normal[2][place(x, y)] = turned ? 0.0f : 1.0f;
                picture.depth[place(x, y)] = turned ? 5.0f : 7.0f;
            }
        trace(picture, one, 8, normal_noise(0.3));
        NoisyPicture other = picture;
        for (int y = 0; y < rows; ++y)
            for (int x = 70; x < columns; ++x)
                for (Plane& plane : other.light)
                    plane[place(x, y)] *= 1.1f;
        const Rgb a = filter_statistically(picture), b = filter_statistically(other);
        for (int y = 0; y < rows; ++y) {
            EXPECT_EQ(a[1][place(66, y)], b[1][place(66, y)]);
            EXPECT_NEAR(a[1][place(69, y)], b[1][place(69, y)], 0.02);
            EXPECT_NE(a[1][place(70, y)], b[1][place(70, y)]);
        }
    }
}

// Two samples, of which one in three meets the light: most pixels show no variance, and many are black. What is not known
// must not count as known.
TEST_P(StatisticalFilter, PixelsThatMissedTheLightGetTheirs)
{
    NoisyPicture picture = make_lit_wall();
    trace(picture, one, 2,
          [](std::mt19937& random) { return std::bernoulli_distribution(1.0 / 3.0)(random) ? 3.0 : 0.0; });
    const Rgb filtered = filter_statistically(picture);
    const double before = error_of(picture, picture.light, one), after = error_of(picture, filtered, one);
    std::printf("light of one sample in three: noise %.3f, filtered %.3f\n", before, after);
    EXPECT_LT(after, 0.3 * before);
    EXPECT_GT(*std::min_element(filtered[0].begin(), filtered[0].end()), 0.1f);
}

// Everything that could be blurred: a step, a slope and waves. At each number of samples the filter is better than none,
// and it converges as the noise does.
TEST_P(StatisticalFilter, IsNeverWorseThanNoiseAndConverges)
{
    const Truth varied = [](int x, int y) {
        return (y < 20 ? 0.5 : 1.0) + (x < 50 ? 0.01 * x : x < 100 ? 0.3 * std::sin(0.6 * x) : 0.0);
    };
    double last = 1e9;
    for (const int count : {1, 2, 8, 32, 128, 512, 2048}) {
        NoisyPicture picture = make_lit_wall();
        // Replicates of count / 8 samples, as the reference has; fewer samples are replicates of one.
        const int used = std::min(count, 8);
        trace(picture, varied, used, normal_noise(0.5 / std::sqrt(static_cast<double>(count) / used)));
        const double before = error_of(picture, picture.light, varied),
                     after = error_of(picture, filter_statistically(picture), varied);
        std::printf("varied light, %4d samples: noise %.5f, filtered %.5f\n", count, before, after);
        EXPECT_LT(after, before) << count;
        EXPECT_LT(after, last) << count;
        last = after;
    }
}

TEST_P(StatisticalFilter, ThreadsDoNotChangeTheResult)
{
    NoisyPicture picture = make_lit_wall();
    trace(
        picture, [](int x, int y) { return 1.0 + 0.01 * x + (y > 30); }, 4, normal_noise(0.3));
    const Rgb expected = filter_statistically(picture);
    for (const int threads : {1, 2, 3}) {
        Rgb found;
        tbb::task_arena(threads).execute([&] { found = filter_statistically(picture); });
        EXPECT_EQ(found, expected);
    }
}

// In every plane at some pixel, and in all of them at some.
TEST_P(StatisticalFilter, HostileValuesStayFinite)
{
    using Limits = std::numeric_limits<float>;
    const float hostile[] = {Limits::quiet_NaN(),
                             Limits::infinity(),
                             -Limits::infinity(),
                             Limits::max(),
                             -Limits::max(),
                             1e20f,
                             -1e12f,
                             1e12f,
                             Limits::min(),
                             Limits::denorm_min(),
                             -0.0f,
                             0.0f};
    NoisyPicture picture = make_lit_wall();
    trace(picture, one, 3, normal_noise(0.3));
    std::mt19937 random(3);
    for (int i = 0; i < 2500; ++i) {
        Rgb* const groups[] = {&picture.light, &picture.variance, &picture.emitted, &picture.albedo,
                               &picture.normal};
        const std::size_t plane = random() % 18, at = random() % picture.depth.size();
        Plane& chosen = plane < 15    ? (*groups[plane / 3])[plane % 3]
                        : plane == 15 ? picture.coverage
                        : plane == 16 ? picture.depth
                                      : picture.freedom;
        chosen[at] = hostile[random() % std::size(hostile)];
    }
    for (const Plane& plane : filter_statistically(picture))
        for (const float value : plane)
            ASSERT_TRUE(std::isfinite(value));
}

TEST_P(StatisticalFilter, EmptyAndTinyPicturesAreFiltered)
{
    EXPECT_TRUE(filter_statistically({})[0].empty());
    NoisyPicture pixel;
    pixel.width = pixel.height = 1;
    pixel.freedom = pixel.depth = pixel.coverage = Plane(1, 1.0f);
    pixel.light = pixel.variance = pixel.albedo = {Plane(1, 0.5f), Plane(1, 0.5f), Plane(1, 0.5f)};
    pixel.emitted = pixel.normal = {Plane(1, 0.0f), Plane(1, 0.0f), Plane(1, 0.0f)};
    EXPECT_NEAR(filter_statistically(pixel)[2][0], 0.5f, 1e-6);
}

TEST_P(StatisticalFilter, PlanesOfAnotherSizeAreRefused)
{
    NoisyPicture picture = make_lit_wall();
    picture.albedo[1].pop_back();
    EXPECT_THROW(filter_statistically(picture), Error);
    picture = make_lit_wall();
    picture.width = -1;
    EXPECT_THROW(filter_statistically(picture), Error);
}

} // namespace
} // namespace lambent::denoise::test
