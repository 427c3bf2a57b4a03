#include "equations/in_double.h"

#include <gtest/gtest.h>

namespace lambent::test {
namespace {

using in_double::cone_attenuation;
using in_double::distance_attenuation;

TEST(Lights, InverseSquareWithoutARange)
{
    for (double distance : {0.01, 1.0, 3.0, 1e4})
        EXPECT_NEAR(distance_attenuation(distance * distance, 0.0) * distance * distance, 1.0, 1e-14);
}

TEST(Lights, RangeBringsItToZero)
{
    // KHR_lights_punctual: max(min(1 - (d / range)^4, 1), 0) / d^2, with a range of 10 m.
    EXPECT_NEAR(distance_attenuation(1.0, 0.1), 0.9999, 1e-14);
    EXPECT_NEAR(distance_attenuation(25.0, 0.1), 0.9375 / 25.0, 1e-14);
    EXPECT_NEAR(distance_attenuation(64.0, 0.1), 0.5904 / 64.0, 1e-14);
    EXPECT_NEAR(distance_attenuation(100.0, 0.1), 0.0, 1e-14);
    EXPECT_EQ(distance_attenuation(121.0, 0.1), 0.0);
}

TEST(Lights, FiniteAtTheLightItself)
{
    EXPECT_LE(distance_attenuation(0.0, 0.1), 1e8);
}

TEST(Lights, ConeFromInnerToOuter)
{
    EXPECT_EQ(cone_attenuation(1.0, 0.9, 0.5), 1.0);
    EXPECT_EQ(cone_attenuation(0.9, 0.9, 0.5), 1.0);
    EXPECT_NEAR(cone_attenuation(0.7, 0.9, 0.5), 0.25, 1e-15);
    EXPECT_NEAR(cone_attenuation(0.6, 0.9, 0.5), 0.0625, 1e-15);
    EXPECT_EQ(cone_attenuation(0.5, 0.9, 0.5), 0.0);
    EXPECT_EQ(cone_attenuation(-1.0, 0.9, 0.5), 0.0);
}

TEST(Lights, ConeWithoutPenumbraIsAStep)
{
    EXPECT_EQ(cone_attenuation(0.8011, 0.8, 0.8), 1.0);
    EXPECT_EQ(cone_attenuation(0.7999, 0.8, 0.8), 0.0);
}

} // namespace
} // namespace lambent::test
