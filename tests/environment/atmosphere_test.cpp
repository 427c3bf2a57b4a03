// Air, haze and ozone against published depths, closed forms, and sums in small steps that share no geometry.
#include "environment/sky/atmosphere.h"

#include "environment/sky/march.h"
#include "environment/sky/sky_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

namespace lambent::environment {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double radius = 6371.0;

// Vertical depth of air at sea level. [Hansen and Travis 1974, "Light scattering in planetary atmospheres"]
double published_air_depth(double nm)
{
    const double inverse = 1e6 / (nm * nm);
    return 0.008569 * inverse * inverse * (1.0 + 0.0113 * inverse + 0.00013 * inverse * inverse);
}

// Sums per_km(densities) along a straight line over a round earth, from its coordinates in the plane it lies in.
template <class PerKm>
double depth_along(const Ray& ray, int steps, const PerKm& per_km)
{
    const double y = radius + ray.altitude, sine = std::sqrt(1.0 - ray.cosine * ray.cosine);
    const double along = y * ray.cosine, top = radius + 80.0;
    const double length = -along + std::sqrt(along * along - y * y + top * top);
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double share = (i + 0.5) / steps, t = length * share * share * share;
        const double altitude = std::hypot(t * sine, y + t * ray.cosine) - radius;
        sum += 3.0 * share * share * length / steps * per_km(altitude);
    }
    return sum;
}

std::vector<Ray> rays_to_space()
{
    std::vector<Ray> rays = {{0.0, 1.0}, {0.0, 0.0}, {0.3, 0.0}, {79.0, 1.0}, {79.0, -0.05}, {0.3, -0.005}};
    std::mt19937 random(4);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int i = 0; i < 60; ++i) {
        const double altitude = 80.0 * std::pow(share(random), 3);
        const double lowest = horizon_cosine(altitude), upward = std::pow(share(random), 3);
        rays.push_back({altitude, lowest + upward * (1.0 - lowest)});
    }
    return rays;
}

TEST(Atmosphere, AirIsAsDeepAsPublished)
{
    const Atmosphere atmosphere(1.0);
    const Spectrum at_ground = atmosphere.air_scattering(atmosphere.densities(0.0));
    const double column =
        depth_along({0.0, 1.0}, 2000, [&](double h) { return atmosphere.densities(h).air; });
    for (int i = 0; i < band_count; ++i) {
        const double nm = band_wavelengths[static_cast<std::size_t>(i)];
        const double depth = static_cast<double>(at_ground[i]) * column;
        EXPECT_NEAR(depth / published_air_depth(nm), 1.0, 0.01) << nm << " nm";
    }
    EXPECT_NEAR(published_air_depth(550.0), 0.0973, 0.0001); // as everybody has it
}

TEST(Atmosphere, TurbidityIsTheRatioOfDepthsAt550Nanometres)
{
    const Spectrum air = Atmosphere(1.0).transmittance({0.0, 1.0});
    for (const double turbidity : {1.5, 2.2, 10.0}) {
        const Spectrum both = Atmosphere(turbidity).transmittance({0.0, 1.0});
        // Haze follows a power of wavelength: linear in logarithms, from 520 to 560 nm.
        const double at_520 = std::log(static_cast<double>(air[3] / both[3]));
        const double at_560 = std::log(static_cast<double>(air[4] / both[4]));
        const double share = std::log(550.0 / 520.0) / std::log(560.0 / 520.0);
        const double haze = std::exp((1.0 - share) * std::log(at_520) + share * std::log(at_560));
        EXPECT_NEAR(1.0 + haze / published_air_depth(550.0), turbidity, 0.01 * turbidity);
    }
}

// Through an exponential atmosphere along the horizontal: R e^(R/H) K1(R/H). [Chapman 1931]
double horizontal_column(double scale_height)
{
    const double x = radius / scale_height;
    return radius * std::sqrt(pi / (2.0 * x)) * (1.0 + 3.0 / (8.0 * x) - 15.0 / (128.0 * x * x));
}

TEST(Atmosphere, HorizontalWaysAreAsLongAsChapmans)
{
    const Ray level{0.0, 0.0};
    const Spectrum clear = Atmosphere(1.0).transmittance(level), hazy = Atmosphere(1.5).transmittance(level);
    // At 400 nm ozone takes next to nothing.
    const double air = -std::log(static_cast<double>(clear[0]));
    EXPECT_NEAR(air / (published_air_depth(400.0) * horizontal_column(8.0) / 8.0), 1.0, 0.01);
    const double haze = std::log(static_cast<double>(clear[7] / hazy[7]));
    const double vertical = 0.5 * published_air_depth(550.0) * std::pow(680.0 / 550.0, -1.3);
    EXPECT_NEAR(haze / (vertical * horizontal_column(1.2) / 1.2), 1.0, 0.01);
}

TEST(Atmosphere, OzoneTakesItsKnownShare)
{
    const Spectrum left = Atmosphere(1.0).transmittance({0.0, 1.0});
    const auto ozone = [&](int band, double nm) {
        return -std::log(static_cast<double>(left[band])) - published_air_depth(nm);
    };
    // Chappuis band: about 0.037 for 300 Dobson units at its peak near 600 nm, nothing in the violet.
    EXPECT_NEAR(ozone(5, 600.0), 0.037, 0.003);
    EXPECT_NEAR(ozone(0, 400.0), 0.0, 0.004);
    EXPECT_LT(ozone(7, 680.0), 0.5 * ozone(5, 600.0));
}

TEST(Atmosphere, WhatGetsThroughAgreesWithSmallSteps)
{
    double by_steps = 0.0, by_table = 0.0;
    for (const double turbidity : {1.5, 6.0}) {
        const Atmosphere atmosphere(turbidity);
        for (const Ray& ray : rays_to_space())
            for (const int band : {0, 5}) {
                const auto extinct = [&](double h) {
                    return static_cast<double>(atmosphere.extinction(atmosphere.densities(h))[band]);
                };
                const auto deflect = [&](double h) {
                    return static_cast<double>(atmosphere.deflection(atmosphere.densities(h))[band]);
                };
                const double all = std::exp(-depth_along(ray, 2000, extinct));
                const double part = std::exp(-depth_along(ray, 2000, deflect));
                const double error = static_cast<double>(atmosphere.transmittance(ray)[band]) - all;
                const double table_error = static_cast<double>(atmosphere.undeflected(ray)[band]) - part;
                by_steps = std::max(by_steps, std::fabs(error));
                by_table = std::max(by_table, std::fabs(table_error));
                EXPECT_NEAR(error, 0.0, 0.002) << ray.altitude << ' ' << ray.cosine;
                EXPECT_NEAR(table_error, 0.0, 0.01) << ray.altitude << ' ' << ray.cosine;
            }
    }
    std::printf("worst error of transmittance: %.5f integrated, %.5f from the table\n", by_steps, by_table);
}

TEST(Atmosphere, RaysEndWhereCoordinatesSay)
{
    for (const Ray& ray : rays_to_space()) {
        const double y = radius + ray.altitude, sine = std::sqrt(1.0 - ray.cosine * ray.cosine);
        const double to_space = distance_to_space(ray);
        EXPECT_NEAR(std::hypot(to_space * sine, y + to_space * ray.cosine), radius + 80.0, 1e-8);
        const Ray there = further_along(ray, 0.4 * to_space);
        const double t = 0.4 * to_space, x = t * sine, z = y + t * ray.cosine;
        EXPECT_NEAR(there.altitude, std::hypot(x, z) - radius, 1e-8);
        EXPECT_NEAR(there.cosine, (x * sine + z * ray.cosine) / std::hypot(x, z), 1e-9);
        // The horizon touches the ground; below it a ray ends there.
        EXPECT_NEAR(y * std::sqrt(1.0 - std::pow(horizon_cosine(ray.altitude), 2)), radius, 1e-8);
        const double down = -0.5 + 0.5 * horizon_cosine(ray.altitude),
                     to_ground = distance_to_ground({ray.altitude, down});
        EXPECT_NEAR(std::hypot(to_ground * std::sqrt(1.0 - down * down), y + to_ground * down), radius, 1e-8);
    }
}

TEST(Atmosphere, TheEdgeHidesPartOfTheSun)
{
    constexpr int n = 1000;
    for (const double altitude : {0.0, 0.3, 50.0})
        for (const double above : {-1.5, -1.0, -0.6, 0.0, 0.3, 0.9, 1.2}) {
            int visible = 0, all = 0; // of a grid of points on the disc
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) {
                    const double x = (2.0 * i + 1.0) / n - 1.0, y = (2.0 * j + 1.0) / n - 1.0;
                    const bool inside = x * x + y * y < 1.0;
                    all += inside;
                    visible += inside && y + above > 0.0;
                }
            const double elevation = std::asin(horizon_cosine(altitude)) + above * 0.265 * pi / 180.0;
            EXPECT_NEAR(visible_sun({altitude, std::sin(elevation)}), static_cast<double>(visible) / all,
                        2e-3);
        }
}

TEST(March, WhatDoesNotPassIsSentBack)
{
    const Atmosphere atmosphere(3.0);
    for (const Ray& ray : rays_to_space()) {
        Spectrum stopped;
        const auto visit = [&](double, const Ray&, const Densities& d, const Spectrum& weight) {
            stopped += weight * atmosphere.deflection(d);
        };
        const Spectrum passed = march(atmosphere, ray, distance_to_space(ray), 32, visit);
        for (int i = 0; i < band_count; ++i) {
            EXPECT_NEAR(passed[i] + stopped[i], 1.0f, 2e-4f);
            EXPECT_NEAR(passed[i], atmosphere.undeflected(ray)[i], 0.02f)
                << ray.altitude << ' ' << ray.cosine;
        }
    }
}

TEST(March, StepsActAsLongAsTheirClosedForm)
{
    for (double depth = 1e-7; depth < 20.0; depth *= 1.7) {
        const Spectrum extinction = Spectrum::all(0.04f);
        const float length = static_cast<float>(depth / 0.04);
        const float acts = effective_length(extinction, transmitted(length * extinction), length)[3];
        EXPECT_NEAR(static_cast<double>(acts) * 0.04 / -std::expm1(-depth), 1.0, 1e-4) << depth;
    }
}

TEST(Phase, ScattersAllLightSomewhere)
{
    constexpr int steps = 20000;
    double air = 0.0, haze = 0.0, ahead = 0.0, mean = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double cosine = (2.0 * i + 1.0) / steps - 1.0, ring = 2.0 * pi * 2.0 / steps;
        air += air_phase(cosine) * ring;
        haze += haze_phase(cosine) * ring;
        mean += cosine * haze_phase(cosine) * ring;
        ahead += cosine * air_phase(cosine) * ring;
    }
    EXPECT_NEAR(air, 1.0, 1e-6);
    EXPECT_NEAR(haze, 1.0, 1e-4);
    EXPECT_NEAR(ahead, 0.0, 1e-9);
    EXPECT_NEAR(mean, 0.70, 1e-4);
}

TEST(SkySpectrum, TheWholeOfSunlightIsTheLuminousSolarConstant)
{
    const Rgb c = sunlight_rgb(Spectrum::all(1.0f));
    const float luminance = 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b;
    // [133.1 klx: Darula, Kittler and Gueymard 2005, "Reference luminous solar constant"]
    EXPECT_NEAR(luminance, 133.1e3f, 0.02f * 133.1e3f);
    EXPECT_NEAR(c.r / c.b, 1.0f, 0.15f) << "white to daylight film";
}

} // namespace
} // namespace lambent::environment
