#include "tests/equations/directions.h"
#include "tests/equations/quadrature.h"
#include "tests/support/chi_square.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lambent::test {
namespace {

using in_double::brdf_phong;
using in_double::log2_density_phong;
using in_double::log2_lobe_density_phong;
using in_double::masking_phong;
using in_double::Phong;
using in_double::phong_exponent;
using in_double::sample_phong;

constexpr std::array<double, 6> exponents = {0.01, 1.0, 20.0, 625.0, 15625.0, 1e6};

TEST(Phong, FacetsCoverTheSurfaceOnce)
{
    for (double alpha : exponents) {
        const auto area = [&](double c) {
            return c > 0.0 ? std::exp2(log2_density_phong(c, alpha)) * c : 0.0;
        };
        EXPECT_NEAR(integrate_about_pole(area), 1.0, 1e-6) << alpha;
    }
}

TEST(Phong, LogarithmReachesWhereTheDensityDoesNot)
{
    // D = (alpha + 2) / (2 pi) cos^alpha. At the peak, and where D itself is 2^-1000000.
    EXPECT_NEAR(log2_density_phong(1.0, 2.0), std::log2(4.0 / (2.0 * pi)), 1e-14);
    EXPECT_NEAR(log2_density_phong(0.5, 3.0), std::log2(5.0 / (2.0 * pi) / 8.0), 1e-14);
    EXPECT_NEAR(log2_density_phong(0.5, 1e6), -1e6 + std::log2(1000002.0 / (2.0 * pi)), 1e-8);
}

TEST(Phong, MaskingIsAQuarterOfTheInverseSquare)
{
    EXPECT_DOUBLE_EQ(masking_phong(1.0), 0.25);
    EXPECT_DOUBLE_EQ(masking_phong(0.5), 1.0);
    EXPECT_DOUBLE_EQ(masking_phong(0.01), 2500.0);
    EXPECT_LE(masking_phong(0.0), 250000.1);
}

const Phong material = {vec3(0.5, 0.3, 0.0), vec3(0.04, 0.5, 1.0), 20.0};

// The report's formula term by term, from angles: N is +z, the light and the view lie theta to either side of
// it.
TEST(Phong, ClosedFormInTheMirrorDirection)
{
    for (double theta : {0.0, 0.3, 1.0, 1.4}) {
        const vec3 f =
            brdf_phong(material, vec3(0, 0, 1), from_angles(theta, 0.4), from_angles(theta, 0.4 + pi));
        const double D = 22.0 / (2.0 * pi), c = std::cos(theta), weight = std::pow(1.0 - c, 5.0);
        EXPECT_NEAR(f.x, 0.5 / pi + D * (0.04 + 0.96 * weight) / (4.0 * c * c), 1e-10);
        EXPECT_NEAR(f.y, 0.3 / pi + D * (0.5 + 0.5 * weight) / (4.0 * c * c), 1e-10);
        EXPECT_NEAR(f.z, D / (4.0 * c * c), 1e-10);
    }
}

TEST(Phong, ClosedFormOffTheMirrorDirection)
{
    // The view along N, the light at theta: the half vector is at theta / 2 from all three.
    for (double theta : {0.2, 0.9, 1.5}) {
        const vec3 f = brdf_phong(material, vec3(0, 0, 1), vec3(0, 0, 1), from_angles(theta, 1.0));
        const double c = std::cos(0.5 * theta), D = 22.0 / (2.0 * pi) * std::pow(c, 20.0);
        EXPECT_NEAR(f.x, 0.5 / pi + D * (0.04 + 0.96 * std::pow(1.0 - c, 5.0)) / (4.0 * c * c), 1e-10);
    }
}

TEST(Phong, Reciprocal)
{
    Uniform uniform(1);
    for (int i = 0; i < 1000; i++) {
        const vec3 N = random_direction(uniform), V = random_direction(uniform),
                   L = random_direction(uniform);
        const Phong p = {vec3(0.2), vec3(0.1, 0.5, 0.9), uniform.between_log(0.01, 1e6)};
        const vec3 there = brdf_phong(p, N, V, L), back = brdf_phong(p, N, L, V);
        EXPECT_LE(distance(there, back), 1e-9 * (1.0 + distance(there, vec3(0.0))));
    }
}

TEST(Phong, LobeDensityIntegratesToOne)
{
    for (double alpha : exponents) {
        // The cosine is xi2^(1 / (alpha + 1)), so log2 xi2 = (alpha + 1) log2 cosine.
        const auto density = [&](double c) {
            return c > 0.0 ? std::exp2(log2_lobe_density_phong((alpha + 1.0) * std::log2(c), alpha)) : 0.0;
        };
        EXPECT_NEAR(integrate_about_pole(density), 1.0, 1e-6) << alpha;
    }
}

// Samples in cells of equal probability under (alpha + 1) / (2 pi) cos^alpha, whose distribution is
// cos^(alpha + 1).
std::vector<double> count_samples(double sampled_alpha, double expected_alpha, uint64_t seed)
{
    constexpr size_t rows = 20, columns = 36;
    Uniform uniform(seed);
    return count(200000, rows * columns, [&] {
        const double xi1 = uniform(), xi2 = uniform();
        const vec3 point(std::log2(xi2), std::cos(2.0 * pi * xi1), std::sin(2.0 * pi * xi1));
        const vec3 d = sample_phong(point, sampled_alpha);
        const double share = std::pow(d.z, expected_alpha + 1.0);
        return part_of(share, rows) * columns + part_of_turn(std::atan2(d.y, d.x), columns);
    });
}

TEST(Phong, SamplesFollowTheirDensity)
{
    uint64_t seed = 1;
    for (double alpha : exponents)
        EXPECT_TRUE(follows_evenly(count_samples(alpha, alpha, seed++))) << alpha;
}

// Would the test notice? The + 2 of the facet density in place of the lobe's + 1.
TEST(Phong, SamplesOfAnExponentOneOffAreRefused)
{
    EXPECT_FALSE(follows_evenly(count_samples(21.0, 20.0, 9)));
}

TEST(Phong, SamplesAreUnitVectors)
{
    for (double alpha : exponents)
        for (double xi2 : {1e-9, 0.5, 1.0 - 1e-9}) {
            const vec3 d = sample_phong(vec3(std::log2(xi2), 0.6, 0.8), alpha);
            EXPECT_NEAR(std::hypot(d.x, d.y, d.z), 1.0, 1e-9);
        }
}

// The Phong and the GGX lobe of a roughness have the same density at the peak: (exponent + 2) / (2 pi) = 1 /
// (pi alpha^2).
TEST(Phong, ExponentHasThePeakOfTheRoughness)
{
    for (double alpha : {0.002, 0.01, 0.1, 0.5, 0.9})
        EXPECT_NEAR((phong_exponent(alpha) + 2.0) / (2.0 * pi) * pi * alpha * alpha, 1.0, 1e-12) << alpha;
    for (double exponent : {0.1, 1.0, 20.0, 15625.0, 9e5})
        EXPECT_NEAR(phong_exponent(in_double::phong_alpha(exponent)) / exponent, 1.0, 1e-9) << exponent;
    EXPECT_EQ(phong_exponent(1.0), 0.01);
    EXPECT_EQ(phong_exponent(1e-4), 1e6);
}

// Curvature of the logarithm of a density at the peak, by central differences.
template <class LogDensity>
double curvature(const LogDensity& f, double step)
{
    return (f(step) - 2.0 * f(0.0) + f(-step)) / (step * step);
}

// And its curvature there is that of Beckmann's distribution, exp(-tan^2 / alpha^2) / cos^4, but for a
// constant 2 (Walter et al. 2007, 5.2); GGX's own is twice as large.
TEST(Phong, ExponentHasTheCurvatureOfBeckmann)
{
    for (double alpha : {0.01, 0.05, 0.2}) {
        const double exponent = phong_exponent(alpha), step = 1e-2 * alpha;
        const auto phong = [&](double t) { return exponent * std::log(std::cos(t)); };
        const auto beckmann = [&](double t) {
            return -std::pow(std::tan(t) / alpha, 2.0) - 4.0 * std::log(std::cos(t));
        };
        const auto ggx = [&](double t) { return std::log(in_double::density_ggx(std::cos(t), alpha)); };
        EXPECT_NEAR(curvature(phong, step) / (curvature(beckmann, step) - 2.0), 1.0, 1e-3) << alpha;
        EXPECT_NEAR(curvature(ggx, step) / curvature(phong, step), 2.0, 2e-3) << alpha;
    }
}

} // namespace
} // namespace lambent::test
