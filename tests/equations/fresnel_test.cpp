#include "equations/in_double.h"

#include <gtest/gtest.h>

namespace lambent::test {
namespace {

using in_double::fresnel_schlick;
using in_double::schlick_weight;
using in_double::vec3;

// Reflectance of unpolarised light at a dielectric of refractive index n. [Fresnel's equations; Snell's law]
double exact_fresnel(double cosine, double n)
{
    const double refracted = std::sqrt(1.0 - (1.0 - cosine * cosine) / (n * n));
    const double s = (cosine - n * refracted) / (cosine + n * refracted);
    const double p = (refracted - n * cosine) / (refracted + n * cosine);
    return 0.5 * (s * s + p * p);
}

double normal_reflectance(double n)
{
    return std::pow((n - 1.0) / (n + 1.0), 2.0);
}

// Schlick's curve is not exact. Against Fresnel's equations it is wrong by at most so much, always near 85
// degrees (its error at a refractive index, which another program found over all angles).
TEST(Fresnel, SchlickIsCloseToTheExactEquations)
{
    struct Case {
        double n, error;
    };
    for (const auto [n, worst] : {Case{1.5, 0.0357}, Case{1.7, 0.0320}, Case{2.0, 0.0445}}) {
        const vec3 F0(normal_reflectance(n));
        double seen = 0.0;
        for (int degrees = 0; degrees <= 90; degrees++) {
            const double cosine = std::cos(degrees * 3.141592653589793 / 180.0);
            seen = std::max(seen, std::abs(fresnel_schlick(F0, cosine).x - exact_fresnel(cosine, n)));
        }
        EXPECT_LT(seen, worst) << "n " << n;
        EXPECT_GT(seen, 0.9 * worst) << "n " << n;
    }
}

TEST(Fresnel, EndsAreExact)
{
    const vec3 F0(0.02, 0.5, 1.0);
    for (int i = 0; i < 3; i++) {
        const double low = i == 0 ? 0.02 : i == 1 ? 0.5 : 1.0;
        const vec3 normal = fresnel_schlick(F0, 1.0), grazing = fresnel_schlick(F0, 0.0);
        EXPECT_DOUBLE_EQ(i == 0 ? normal.x : i == 1 ? normal.y : normal.z, low);
        EXPECT_DOUBLE_EQ(i == 0 ? grazing.x : i == 1 ? grazing.y : grazing.z, 1.0);
    }
}

TEST(Fresnel, DielectricsHaveAnIndexOfOneAndAHalf)
{
    EXPECT_NEAR(in_double::dielectric_reflectance(), normal_reflectance(1.5), 1e-15);
    const vec3 gold(1.0, 0.77, 0.34);
    EXPECT_EQ(in_double::base_reflectance(gold, 1.0).y, 0.77);
    EXPECT_EQ(in_double::base_reflectance(gold, 0.0).y, 0.04);
    EXPECT_NEAR(in_double::base_reflectance(gold, 0.25).z, 0.75 * 0.04 + 0.25 * 0.34, 1e-15);
}

TEST(Fresnel, WeightIsTheFifthPower)
{
    for (double cosine : {0.0, 0.1, 0.25, 0.5, 0.9, 1.0})
        EXPECT_NEAR(schlick_weight(cosine), std::pow(1.0 - cosine, 5.0), 1e-15);
}

} // namespace
} // namespace lambent::test
