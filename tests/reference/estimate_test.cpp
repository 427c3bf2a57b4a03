// What replicates tell of a value, over everything that can happen to it.
#include "reference/samples/estimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace lambent::reference {
namespace {

constexpr double not_cut = std::numeric_limits<double>::infinity();

// Sample i is low or high as `bits` says.
using Deal = std::function<double(unsigned bits, int i)>;

Sums sums_of(const Deal& deal, unsigned bits, int samples)
{
    Sums sums{};
    for (int i = 0; i < samples; ++i)
        sums[static_cast<std::size_t>(i % replicates)] += static_cast<float>(deal(bits, i));
    return sums;
}

// Means over all settings of `coins` fair coins: of the estimated variance, and of the square of what the mean is off.
struct Expectations {
    double estimated = 0.0, actual = 0.0;
};

Expectations over_all(const Deal& deal, int samples, int coins, double truth)
{
    Expectations e;
    const unsigned count = 1u << coins;
    for (unsigned bits = 0; bits < count; ++bits) {
        const Estimate found = estimate(sums_of(deal, bits, samples), samples, not_cut);
        e.estimated += found.variance / count;
        e.actual += (found.mean - truth) * (found.mean - truth) / count;
    }
    return e;
}

// Samples 1 or 4 by fair coins: variance 9/4 of each. No matter how many replicates have one sample more than others.
TEST(ReferenceEstimate, VarianceHasNoBiasForAnyNumberOfIndependentSamples)
{
    const Deal coins = [](unsigned bits, int i) { return bits >> i & 1u ? 4.0 : 1.0; };
    for (int samples = 2; samples <= 16; ++samples) {
        const Expectations e = over_all(coins, samples, samples, 2.5);
        EXPECT_NEAR(e.actual, 2.25 / samples, 1e-12);
        EXPECT_NEAR(e.estimated, e.actual, 1e-12) << samples << " samples";
    }
}

// A replicate's second sample is the opposite of its first, as evenly spread points are: two have no variance at all.
TEST(ReferenceEstimate, VarianceHasNoBiasWhereSamplesOfAReplicateBalance)
{
    const Deal pairs = [](unsigned bits, int i) {
        const bool first = (bits >> i % replicates & 1u) != 0;
        return first == (i < replicates) ? 4.0 : 1.0;
    };
    for (int samples = 9; samples <= 16; ++samples) {
        const Expectations e = over_all(pairs, samples, replicates, 2.5);
        EXPECT_NEAR(e.actual, 2.25 * (16 - samples) / (samples * samples), 1e-12);
        EXPECT_NEAR(e.estimated, e.actual, 1e-12) << samples << " samples";
    }
}

TEST(ReferenceEstimate, OneSampleTellsNoVariance)
{
    const Estimate e = estimate({3.0f}, 1, 2.0);
    EXPECT_EQ(e.mean, 3.0);
    EXPECT_EQ(e.cut_mean, 2.0);
    EXPECT_TRUE(std::isinf(e.variance));
    EXPECT_TRUE(std::isinf(e.cut_error));
}

TEST(ReferenceEstimate, BelowTheCutNothingIsCut)
{
    const Estimate e = estimate({1.0f, 3.0f}, 2, 2.5);
    EXPECT_EQ(e.cut_mean, 2.0);
    EXPECT_EQ(e.variance, 1.0);
    EXPECT_EQ(e.cut_error, 1.0);
}

// By hand: one of eight samples is 80, the others are 0; cut at 1. Without the one, the mean is 0; without another, 80 / 7,
// cut to 1. Their mean is 7/8, and 7/8 of the sum of squares around it, 7/8, is 49/64. The variance not cut is 100.
TEST(ReferenceEstimate, AboveTheCutTheJackknifeTellsWhetherTheTruthMayBeBelow)
{
    Sums sums{};
    sums[5] = 80.0f;
    const Estimate e = estimate(sums, 8, 1.0);
    EXPECT_EQ(e.cut_mean, 1.0);
    EXPECT_NEAR(e.variance, 100.0, 1e-9);
    EXPECT_NEAR(e.cut_error, 49.0 / 64.0, 1e-9);
}

TEST(ReferenceEstimate, FarAboveTheCutIsCertain)
{
    Sums sums{};
    for (int r = 0; r < replicates; ++r)
        sums[static_cast<std::size_t>(r)] = 10.0f + static_cast<float>(r);
    for (const int samples : {8, 13, 16})
        EXPECT_NEAR(estimate(sums, samples, 1.0).cut_error, 0.0, 1e-12);
}

TEST(ReferenceEstimate, AtTheCutHalfOfTheDeviationsCount)
{
    // Four replicates of 1 and four of 3: their mean is 2.
    Sums sums{};
    for (int r = 0; r < replicates; ++r)
        sums[static_cast<std::size_t>(r)] = r % 2 == 0 ? 1.0f : 3.0f;
    const Estimate at = estimate(sums, 8, 2.0), above = estimate(sums, 8, 5.0);
    EXPECT_NEAR(above.cut_error, 1.0 / 7.0, 1e-9);
    // Without a 3 it is 13/7; without a 1, 15/7, cut to 2: 7/8 of the sum of squares around their mean, 8 / 14^2.
    EXPECT_NEAR(at.cut_error, 7.0 / 196.0, 1e-9);
}

} // namespace
} // namespace lambent::reference
