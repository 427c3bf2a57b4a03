// The interval of a ratio, from samples of known distributions.
#include "audit/interval.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace lambent::audit {
namespace {

Observation of(double square, double difference = 0.0)
{
    const Moments m{square, difference};
    return {1.0, m, {m, m}};
}

TEST(Interval, the_ratio_is_that_of_the_weighted_means)
{
    std::vector<Observation> seen = {of(0.01, 0.1), of(0.03, -0.1), of(0.05, 0.3), of(0.07, 0.1)};
    const Error plain = error_of(seen, {1000, 0.4, 1});
    EXPECT_NEAR(plain.relative_mse, 0.04 / 0.25, 1e-15);
    EXPECT_NEAR(plain.relative_rmse, 0.4, 1e-15);
    seen[3].weight = 3.0;
    EXPECT_NEAR(error_of(seen, {1000, 0.4, 1}).relative_mse, 0.3 / 4.0 / (0.55 * 0.55), 1e-15);
}

// Squared errors of a lognormal distribution, whose 1 % largest hold a fifth of the sum. A symmetric interval of 512
// misses twice as often as it should, nearly always because it is too low.
TEST(Interval, heavy_tails_are_held_as_often_as_promised)
{
    constexpr int intervals = 250, count = 512;
    const double sigma = 1.5, mean = std::exp(0.5 * sigma * sigma), error = std::sqrt(mean);
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    int held = 0;
    for (int i = 0; i < intervals; ++i) {
        std::vector<Observation> seen;
        for (int k = 0; k < count; ++k)
            seen.push_back(of(std::exp(sigma * normal(random))));
        const Error said = error_of(seen, {1u << 30, 1.0, static_cast<std::uint32_t>(i)});
        held += said.low <= error && error <= said.high;
    }
    // Of 250 that each hold it with a probability between .92 and .97: outside of this once in 10,000 times.
    EXPECT_GE(held, 213);
    EXPECT_LE(held, 249);
}

// Of pixels drawn without replacement, half of all: what is not drawn is all that can be wrong.
TEST(Interval, a_large_part_of_a_small_picture_tells_more_than_the_same_number_of_a_large_one)
{
    std::mt19937 random(6);
    std::vector<Observation> seen;
    for (int k = 0; k < 400; ++k)
        seen.push_back(of(std::exp(std::normal_distribution<double>()(random))));
    const Error large = error_of(seen, {1u << 30, 1.0, 1}), small = error_of(seen, {800, 1.0, 1});
    EXPECT_EQ(large.relative_mse, small.relative_mse);
    // The square's deviation is smaller by sqrt(1 - 400 / 800).
    EXPECT_NEAR((small.relative_mse - small.low * small.low) / (large.relative_mse - large.low * large.low),
                std::sqrt(0.5), 0.01);
}

// Where noise is larger than the error, the square may be negative; the interval of the root then begins at 0.
TEST(Interval, an_error_below_the_noise_has_a_bound)
{
    std::vector<Observation> seen;
    for (int k = 0; k < 100; ++k)
        seen.push_back(of(k % 2 == 0 ? 0.01 : -0.012));
    const Error said = error_of(seen, {1000, 1.0, 1});
    EXPECT_LT(said.relative_mse, 0.0);
    EXPECT_EQ(said.relative_rmse, 0.0);
    EXPECT_EQ(said.low, 0.0);
    EXPECT_GT(said.high, 0.03);
    EXPECT_LT(said.high, 0.08);
}

TEST(Interval, no_light_gives_no_ratio)
{
    EXPECT_FALSE(std::isfinite(error_of({of(0.01), of(0.02)}, {10, 0.0, 1}).high));
}

} // namespace
} // namespace lambent::audit
