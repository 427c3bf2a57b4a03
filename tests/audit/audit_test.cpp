// Pictures whose error is known in closed form: that of the audit is it, on average over many seeds, whatever the noise.
#include "tests/audit/synthetic.h"

#include <tbb/global_control.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <mutex>

namespace lambent::audit::testing {
namespace {

constexpr int width = 160, height = 100;

// A normal variable is further off than this once in 1.7 million times: the false-alarm rate of one comparison.
constexpr double deviations = 5.0;

Error measured(const image::RadianceImage& picture, const Settings& settings, const PixelLight& light)
{
    const std::optional<Error> error = measure(picture, settings, light);
    EXPECT_TRUE(error.has_value());
    return error.value_or(Error());
}

struct Average {
    double mean = 0.0, deviation = 0.0; ///< standard deviation of the mean
    double spread = 0.0;                ///< of one audit
};

// Of relative_mse over `audits` seeds.
Average average(const image::RadianceImage& picture, Settings settings, const PixelLight& light,
                int audits = 100)
{
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < audits; ++i) {
        settings.seed = static_cast<std::uint32_t>(i);
        const double value = measured(picture, settings, light).relative_mse;
        sum += value;
        squares += value * value;
    }
    const double mean = sum / audits, spread = std::sqrt(std::max(squares / audits - mean * mean, 0.0));
    return {mean, spread / std::sqrt(audits), spread};
}

void expect_average(const Average& seen, double expected)
{
    EXPECT_NEAR(seen.mean, expected, deviations * seen.deviation + 1e-12) << "deviation " << seen.deviation;
}

double half(int, int)
{
    return 0.5;
}

TEST(Audit, an_offset_without_noise_is_the_error_to_the_last_digit)
{
    const Error error =
        measured(picture_of(width, height, [](int, int) { return 0.75; }), {}, noisy(half, 0.0));
    EXPECT_DOUBLE_EQ(error.relative_rmse, 0.5);
    EXPECT_DOUBLE_EQ(error.low, 0.5);
    EXPECT_DOUBLE_EQ(error.high, 0.5);
    EXPECT_EQ(error.confidence, 0.95);
    EXPECT_EQ(error.pixels, 512);
}

// An error of a tenth, seen through noise of a fifth.
TEST(Audit, an_offset_is_found_through_noise)
{
    const image::RadianceImage picture = picture_of(width, height, [](int, int) { return 0.55; });
    const Average seen = average(picture, {}, noisy(half, 0.1));
    expect_average(seen, 0.01);
    EXPECT_LT(seen.spread, 0.003);
    const Error one = measured(picture, {}, noisy(half, 0.1));
    EXPECT_LT(one.low, one.relative_rmse);
    EXPECT_GT(one.high, one.relative_rmse);
    EXPECT_GT(one.low, 0.05);
    EXPECT_LT(one.high, 0.15);
}

TEST(Audit, noise_in_the_picture_is_error_and_noise_in_the_truth_is_not)
{
    double square = 0.0;
    const Grey speckled = [](int x, int y) { return 0.5 + 0.05 * normal(x, y, 3); };
    const image::RadianceImage picture = picture_of(width, height, speckled);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            square += std::pow((speckled(x, y) - 0.5) / 0.5, 2) / (width * height);
    expect_average(average(picture, {}, noisy(half, 0.02)), square);
    expect_average(average(picture, {}, noisy(half, 0.2)), square);
}

// What is hidden by noise is not said to be an error, nor to be none.
TEST(Audit, a_perfect_picture_has_no_error_on_average_and_one_that_noise_bounds)
{
    const image::RadianceImage picture = picture_of(width, height, half);
    expect_average(average(picture, {}, noisy(half, 0.1)), 0.0);
    int above_zero = 0;
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        Settings settings;
        settings.seed = seed;
        const Error error = measured(picture, settings, noisy(half, 0.1));
        EXPECT_GE(error.relative_rmse, 0.0);
        EXPECT_GT(error.high, 0.0);
        EXPECT_LT(error.high, 0.2);
        above_zero += error.low > 0.0;
    }
    EXPECT_LE(above_zero, 15); // 2.5 expected; more than 15 of 100 has a probability below 1e-7
}

// One pixel in 200 holds all of the error, and nothing in the picture tells which. Chosen blindly, two or three of 512
// pixels would show it.
TEST(Audit, few_wrong_pixels_are_found_without_bias)
{
    const image::RadianceImage picture = picture_of(width, height, half);
    const PixelLight truth = noisy([](int x, int y) { return (x + width * y) % 200 == 7 ? 0.0 : 0.5; }, 0.01);
    Settings blind;
    blind.candidates = 1;
    const Average at_a_glance = average(picture, {}, truth), blindly = average(picture, blind, truth);
    const double light = 0.5 * 199 / 200, expected = 0.25 / 200 / (light * light);
    expect_average(at_a_glance, expected);
    expect_average(blindly, expected);
    EXPECT_LT(at_a_glance.spread, 0.4 * blindly.spread);
}

// The same where the picture has contrast at what is wrong, as at edges and highlights.
TEST(Audit, wrong_pixels_that_stand_out_are_found_without_bias)
{
    const image::RadianceImage picture = picture_of(width, height, [](int x, int y) {
        return (x + width * y) % 2000 == 77 ? 0.0 : 0.5 + 0.001 * (x % 3);
    });
    Settings few;
    few.pixels = 64;
    const Average seen = average(picture, few, noisy(half, 0.01));
    double expected = 8.0 * 0.25 / (width * height);
    for (int x = 0; x < width; ++x)
        expected += 1e-6 * (x % 3) * (x % 3) / width;
    EXPECT_NEAR(seen.mean, expected / 0.25, 5.0 * seen.deviation + 0.002 * expected);
    EXPECT_LT(seen.spread, expected / 0.25); // blindly: five times this
}

TEST(Audit, light_above_the_cut_is_as_bright_as_it)
{
    Settings settings;
    settings.cut = 1.0;
    const image::RadianceImage bright = picture_of(width, height, [](int, int) { return 30.0; });
    EXPECT_EQ(measured(bright, settings, noisy([](int, int) { return 2.0; }, 0.0)).relative_rmse, 0.0);
    EXPECT_DOUBLE_EQ(measured(bright, settings, noisy(half, 0.0)).relative_rmse, 1.0);
    EXPECT_DOUBLE_EQ(measured(bright, {}, noisy([](int, int) { return 2.0; }, 0.0)).relative_rmse, 14.0);
}

// The worst case: the truth is the cut itself. Half of the noise is cut off; the means are too low by 0.4 of their
// deviation, 0.1, squared 0.0016. The jackknife leaves (2 x 0.4 - 0.4 x sqrt(2)) squared, a third.
TEST(Audit, noise_at_the_cut_is_hardly_taken_for_an_error)
{
    Settings settings;
    settings.cut = 1.0;
    const Grey one = [](int, int) { return 1.0; };
    const Average seen = average(picture_of(width, height, one), settings, noisy(one, 0.1));
    EXPECT_LT(seen.mean, 0.5 * 0.0016);
    EXPECT_GT(seen.mean, 0.2 * 0.0016);
}

TEST(Audit, values_that_are_not_finite_count_as_black)
{
    image::RadianceImage picture = picture_of(width, height, half);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.pixel(x, y)[x % 3] =
                x % 2 == 0 ? std::numeric_limits<float>::quiet_NaN() : std::numeric_limits<float>::infinity();
    EXPECT_NEAR(measured(picture, {}, noisy(half, 0.0)).relative_rmse, std::sqrt(1.0 / 3.0), 1e-3);
}

TEST(Audit, only_covered_pixels_count)
{
    image::RadianceImage picture = picture_of(width, height, [](int x, int) { return x < 80 ? 0.6 : 9.0; });
    for (int y = 0; y < height; ++y)
        for (int x = 80; x < width; ++x)
            picture.pixel(x, y)[3] = 0.0f;
    EXPECT_NEAR(measured(picture, {}, noisy(half, 0.0)).relative_rmse, 0.2, 1e-6);
}

TEST(Audit, nothing_is_said_where_nothing_is_seen)
{
    const image::RadianceImage picture = picture_of(width, height, half);
    EXPECT_FALSE(measure(image::black_image(width, height, 4), {}, noisy(half, 0.1)));
    EXPECT_FALSE(measure(image::black_image(width, height, 3), {}, noisy(half, 0.1)));
    EXPECT_FALSE(measure(picture_of(5, 3, half), {}, noisy(half, 0.1)));
    EXPECT_FALSE(measure(picture, {}, noisy([](int, int) { return 0.0; }, 0.0)));
    EXPECT_TRUE(measure(picture_of(4, 4, half), {}, noisy(half, 0.1)));
}

TEST(Audit, the_number_of_threads_changes_nothing)
{
    const image::RadianceImage picture =
        picture_of(width, height, [](int x, int y) { return 0.005 * (x + y); });
    const auto with = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return measured(picture, {}, noisy(half, 0.1));
    };
    const Error one = with(1), three = with(3);
    EXPECT_EQ(one.relative_mse, three.relative_mse);
    EXPECT_EQ(one.low, three.low);
    EXPECT_EQ(one.high, three.high);
}

// Users give seeds up to 2^30 to the pictures that are audited: none of an audit's is one of these, so its noise is
// independent of the picture's.
TEST(Audit, no_seed_is_one_that_a_picture_could_have)
{
    std::mutex mutex;
    std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
    const PixelLight light = noisy(half, 0.1);
    measured(picture_of(width, height, half), {}, [&](const reference::PixelTracer::Pixel& pixel) {
        const std::lock_guard lock(mutex);
        least = std::min(least, pixel.seed);
        return light(pixel);
    });
    EXPECT_GT(least, 1u << 30);
}

} // namespace
} // namespace lambent::audit::testing
