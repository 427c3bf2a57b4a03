// Weights of prefiltered light against their definition, their curvature against differences on the sphere.
#include "tests/equations/directions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace lambent::test {
namespace {

using in_double::lobe_weight_ggx;
using in_double::lobe_weight_phong;
using in_double::LobeSum;
using in_double::LobeWeight;
using in_double::mean_of_lobe;
using in_double::vec3;

double ggx(double c, double alpha)
{
    const double q = alpha * alpha + (1.0 - alpha * alpha) * 0.5 * (1.0 - c);
    return c / (q * q);
}

// Half the Laplacian on the sphere of a function of the cosine to +z, by geodesic steps along both tangents.
double half_laplacian(const std::function<double(double)>& f, double angle)
{
    constexpr double h = 1e-4;
    const double along = f(std::cos(angle + h)) + f(std::cos(angle - h));
    const double across = 2.0 * f(std::cos(angle) * std::cos(h)); // a great circle square to the meridian
    return 0.5 * (along + across - 4.0 * f(std::cos(angle))) / (h * h);
}

TEST(LobeWeight, IsItsDefinition)
{
    for (const double alpha : {0.05, 0.3, 1.0})
        for (const double angle : {0.0, 0.02, 0.4, 1.2}) {
            const double c = std::cos(angle), versine = 2.0 * std::pow(std::sin(0.5 * angle), 2.0);
            const LobeWeight w = lobe_weight_ggx(c, versine, alpha * alpha);
            EXPECT_NEAR(w.value, ggx(c, alpha), 1e-9 * ggx(c, alpha));
            const double wanted = half_laplacian([&](double x) { return ggx(x, alpha); }, angle);
            EXPECT_NEAR(w.curvature, wanted, 1e-4 * std::fabs(wanted) + 1e-6 * w.value)
                << alpha << " " << angle;
        }
    for (const double exponent : {1.0, 8.0, 500.0})
        for (const double angle : {0.0, 0.02, 0.3, 1.2}) {
            const double c = std::cos(angle), versine = 2.0 * std::pow(std::sin(0.5 * angle), 2.0);
            const LobeWeight w = lobe_weight_phong(c, versine, exponent);
            EXPECT_NEAR(w.value, std::max(std::pow(c, exponent), std::exp2(-120.0)), 1e-9);
            const double wanted = half_laplacian([&](double x) { return std::pow(x, exponent); }, angle);
            EXPECT_NEAR(w.curvature, wanted, 1e-4 * std::fabs(wanted) + 1e-5) << exponent << " " << angle;
        }
}

TEST(LobeWeight, EvenLightStaysEven)
{
    const vec3 light(3.0, 2.0, 1.0);
    for (const double summed : {0.95, 1.0, 1.04}) { // dim cells missed or doubled a little of the integral
        const double dim = summed * 2.0 - 0.5;
        const LobeSum coarse = {dim * light, dim}, fine = {0.5 * light, 0.5};
        EXPECT_LT(distance(mean_of_lobe(coarse, fine, 2.0), light), 1e-12) << summed;
    }
}

TEST(LobeWeight, ASunIsNotDimmedByTheSkyAroundIt)
{
    const LobeSum sky = {vec3(1.9), 1.9}, sun = {vec3(50.0), 0.001};
    const vec3 mean = mean_of_lobe(sky, sun, 2.0);
    EXPECT_NEAR(mean.x, (50.0 + 1.9 * (2.0 - 0.001) / 1.9) / 2.0, 1e-12);
    // Where hardly anything is dim there is nothing to correct by, and never by more than a tenth.
    EXPECT_NEAR(mean_of_lobe({vec3(0.01), 0.01}, {vec3(1.0), 1.0}, 2.0).x, 0.505, 1e-12);
    EXPECT_NEAR(mean_of_lobe({vec3(1.0), 1.0}, {vec3(0.0), 0.0}, 2.0).x, 0.55, 1e-12);
    EXPECT_NEAR(mean_of_lobe({vec3(1.5), 1.5}, {vec3(1.0), 1.0}, 2.0).x, (1.0 + 0.9 * 1.5) / 2.0, 1e-12);
}

} // namespace
} // namespace lambent::test
