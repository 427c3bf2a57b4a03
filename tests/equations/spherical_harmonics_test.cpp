#include "tests/equations/directions.h"
#include "tests/equations/quadrature.h"

#include <gtest/gtest.h>

namespace lambent::test {
namespace {

using in_double::harmonic_irradiance;
using in_double::Harmonics;
using in_double::harmonics;

std::array<double, 9> nine(const Harmonics& h)
{
    return {h.c0, h.c1, h.c2, h.c3, h.c4, h.c5, h.c6, h.c7, h.c8};
}

Harmonics from_nine(const std::array<double, 9>& c)
{
    return {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]};
}

TEST(SphericalHarmonics, OrthonormalByQuadrature)
{
    for (size_t i = 0; i < 9; i++)
        for (size_t j = 0; j <= i; j++) {
            const double product = integrate_sphere([&](double x, double y, double z) {
                const std::array<double, 9> h = nine(harmonics(vec3(x, y, z)));
                return h[i] * h[j];
            });
            EXPECT_NEAR(product, i == j ? 1.0 : 0.0, 1e-12) << i << " " << j;
        }
}

TEST(SphericalHarmonics, OrderAndSigns)
{
    // Each harmonic is a positive multiple of its name in the list: 1; y, z, x; xy, yz, 3z^2-1, xz, x^2-y^2.
    const double x = 0.48, y = 0.6, z = 0.64;
    const std::array<double, 9> named = {1.0, y, z, x, x * y, y * z, 3.0 * z * z - 1.0, x * z, x * x - y * y};
    const std::array<double, 9> h = nine(harmonics(vec3(x, y, z)));
    const std::array<double, 9> norms = {
        0.5 / std::sqrt(pi),        std::sqrt(0.75 / pi),       std::sqrt(0.75 / pi),
        std::sqrt(0.75 / pi),       0.5 * std::sqrt(15.0 / pi), 0.5 * std::sqrt(15.0 / pi),
        0.25 * std::sqrt(5.0 / pi), 0.5 * std::sqrt(15.0 / pi), 0.25 * std::sqrt(15.0 / pi)};
    for (size_t i = 0; i < 9; i++)
        EXPECT_NEAR(h[i], norms[i] * named[i], 1e-14) << i;
}

// Irradiance at the normal of polar angle theta and azimuth phi, by integrating radiance times cosine about
// it.
template <class Radiance>
double irradiance_by_quadrature(const Radiance& radiance, double theta, double phi)
{
    const vec3 n = from_angles(theta, phi), a = from_angles(theta + 0.5 * pi, phi);
    const vec3 b(-std::sin(phi), std::cos(phi), 0.0);
    constexpr int steps = 16;
    const auto ring = [&](double c) {
        const double s = std::sqrt(1.0 - c * c);
        double sum = 0.0;
        for (int i = 0; i < steps; i++) {
            const double p = s * std::cos(2.0 * pi * i / steps), q = s * std::sin(2.0 * pi * i / steps);
            sum += radiance(
                vec3(p * a.x + q * b.x + c * n.x, p * a.y + q * b.y + c * n.y, p * a.z + q * b.z + c * n.z));
        }
        return c * sum * 2.0 * pi / steps;
    };
    return integrate(ring, 0.0, 1.0, 1e-12);
}

TEST(SphericalHarmonics, IrradianceOfEachHarmonic)
{
    for (size_t i = 0; i < 9; i++) {
        std::array<double, 9> coefficients = {};
        coefficients[i] = 1.0;
        for (double theta : {0.0, 0.7, 1.9, 3.0})
            for (double phi : {0.3, 2.0, 5.0}) {
                const double expected =
                    irradiance_by_quadrature([&](vec3 d) { return nine(harmonics(d))[i]; }, theta, phi);
                EXPECT_NEAR(harmonic_irradiance(from_nine(coefficients), from_angles(theta, phi)), expected,
                            1e-10);
            }
    }
}

TEST(SphericalHarmonics, IrradianceOfAPolynomialSky)
{
    // Radiance 2 + y - 0.5 x z + 0.3 y^2, projected and lit by quadrature alone.
    const auto sky = [](double x, double y, double z) { return 2.0 + y - 0.5 * x * z + 0.3 * y * y; };
    std::array<double, 9> coefficients = {};
    for (size_t i = 0; i < 9; i++)
        coefficients[i] = integrate_sphere(
            [&](double x, double y, double z) { return sky(x, y, z) * nine(harmonics(vec3(x, y, z)))[i]; });
    for (double theta : {0.2, 1.2, 2.8}) {
        const double expected =
            irradiance_by_quadrature([&](vec3 d) { return sky(d.x, d.y, d.z); }, theta, 0.9);
        EXPECT_NEAR(harmonic_irradiance(from_nine(coefficients), from_angles(theta, 0.9)), expected, 1e-10);
    }
}

TEST(SphericalHarmonics, UniformSkyGivesPi)
{
    const Harmonics white = {2.0 * std::sqrt(pi), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    EXPECT_NEAR(harmonic_irradiance(white, vec3(0.6, 0.0, 0.8)), pi, 1e-13);
}

} // namespace
} // namespace lambent::test
