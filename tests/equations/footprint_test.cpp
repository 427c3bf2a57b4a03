#include "equations/in_double.h"

#include <gtest/gtest.h>

namespace lambent::test {
namespace {

using in_double::level_of_variance;
using in_double::variance_of_spread;

// Variance of level l over that of level 1: what the chain is made of.
double variance_of_level(int level)
{
    return level == 0 ? 1.0 / 16.0 : std::pow(4.0, level - 1);
}

// Trilinear filtering blends two neighbouring levels; the variances of a mixture of two Gaussians about one
// point add in proportion.
double variance_of_blend(double level)
{
    const int below = static_cast<int>(std::floor(level));
    const double share = level - below;
    return (1.0 - share) * variance_of_level(below) + share * variance_of_level(below + 1);
}

TEST(Footprint, BlendHasTheWantedVarianceOverFourDecades)
{
    for (int i = 0; i <= 4000; i++) {
        const double variance = std::pow(10.0, -1.0 + i / 1000.0);
        EXPECT_NEAR(variance_of_blend(level_of_variance(variance)) / variance, 1.0, 1e-12) << variance;
    }
}

TEST(Footprint, LevelsThemselves)
{
    for (int level = 0; level <= 12; level++)
        EXPECT_NEAR(level_of_variance(variance_of_level(level)), level, 1e-12);
}

TEST(Footprint, NothingIsSharperThanThePicture)
{
    EXPECT_EQ(level_of_variance(0.0), 0.0);
    EXPECT_EQ(level_of_variance(0.0624), 0.0);
}

TEST(Footprint, LevelNeverFalls)
{
    double last = 0.0;
    for (int i = 0; i <= 100000; i++) {
        const double level = level_of_variance(std::pow(10.0, -3.0 + i / 12500.0));
        EXPECT_GE(level, last);
        last = level;
    }
}

TEST(Footprint, DeviationIsTwoThirdsOfTheSpread)
{
    for (double spread : {1e-8, 0.04, 1.0, 6.0})
        EXPECT_NEAR(std::sqrt(variance_of_spread(spread)), std::sqrt(0.45) * std::sqrt(spread), 1e-14);
}

} // namespace
} // namespace lambent::test
