// Welch's test against published tables of the t distribution, and against what its level promises.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace lambent::denoise::test {
namespace {

namespace in_float {
using Real = float;
#include "denoise/welch.h"
} // namespace in_float

// Quantiles t(.995) of Student's t, as every table prints them.
TEST(Welch, CriticalValuesAreThoseOfTheTables)
{
    struct Row {
        float freedom, t;
    };
    for (const Row& row :
         {Row{4, 4.604f}, {5, 4.032f}, {7, 3.499f}, {10, 3.169f}, {20, 2.845f}, {30, 2.750f}, {120, 2.617f}})
        EXPECT_NEAR(in_float::squared_critical_t(1.0f / row.freedom) / (row.t * row.t), 1.0,
                    row.freedom < 7.0f ? 0.03 : 0.005)
            << row.freedom;
    EXPECT_NEAR(std::sqrt(in_float::squared_critical_t(0.0f)), 2.5758, 1e-4);
}

// Of equal variances with n - 1 degrees of freedom each, the difference has 2 n - 2; of very different ones that of the
// greater.
TEST(Welch, FreedomIsThatOfTheFormula)
{
    EXPECT_NEAR(in_float::inverse_freedom(3.0f, 1.0f / 7.0f, 3.0f, 1.0f / 7.0f), 1.0 / 14.0, 1e-6);
    EXPECT_NEAR(in_float::inverse_freedom(1e-6f, 1.0f / 5.0f, 2.0f, 1.0f / 9.0f), 1.0 / 9.0, 1e-6);
    // (1 + 4)^2 / (1 / 4 + 16 / 8)
    EXPECT_NEAR(1.0f / in_float::inverse_freedom(1.0f, 1.0f / 4.0f, 4.0f, 1.0f / 8.0f), 25.0 / 2.25, 1e-4);
}

struct Estimated {
    float mean, variance; ///< the latter of the mean
};

Estimated estimated(std::mt19937& random, int count, double deviation)
{
    std::normal_distribution<double> normal(0.0, deviation);
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < count; ++i) {
        const double value = normal(random);
        sum += value;
        squares += value * value;
    }
    const double mean = sum / count;
    return {static_cast<float>(mean), static_cast<float>((squares / count - mean * mean) / (count - 1))};
}

// The deviation of a share p of n trials is sqrt(p (1 - p) / n). Welch's approximation itself is off by a few tenths of
// the level where variances differ [Scheffé 1970].
TEST(Welch, EqualMeansAreToldApartAsOftenAsTheLevelSays)
{
    constexpr int trials = 100000;
    std::mt19937 random(1);
    for (const auto& [count_a, count_b, ratio] :
         {std::array{8.0, 8.0, 1.0}, {8.0, 8.0, 4.0}, {12.0, 6.0, 1.0}, {30.0, 8.0, 3.0}}) {
        int apart = 0;
        for (int i = 0; i < trials; ++i) {
            const Estimated a = estimated(random, static_cast<int>(count_a), 1.0),
                            b = estimated(random, static_cast<int>(count_b), ratio);
            const auto inverse = [](double count) { return static_cast<float>(1.0 / (count - 1.0)); };
            apart += in_float::welch_ratio(a.mean - b.mean, a.variance, inverse(count_a), b.variance,
                                           inverse(count_b)) > 1.0f;
        }
        const double level = static_cast<double>(in_float::test_level);
        EXPECT_NEAR(static_cast<double>(apart) / trials, level,
                    5.0 * std::sqrt(level / trials) + 0.25 * level)
            << count_a << ' ' << count_b << ' ' << ratio;
    }
}

TEST(Welch, MeansFarApartAreToldApart)
{
    EXPECT_GT(in_float::welch_ratio(8.0f, 1.0f, 1.0f / 7.0f, 1.0f, 1.0f / 7.0f), 1.0f);
    EXPECT_LT(in_float::welch_ratio(2.0f, 1.0f, 1.0f / 7.0f, 1.0f, 1.0f / 7.0f), 1.0f);
}

} // namespace
} // namespace lambent::denoise::test
