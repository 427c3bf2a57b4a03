// The sky against published illuminances and luminances, traced photons, and what everybody has seen.
#include "environment/sky/sky.h"

#include "environment/sky/multiple_scattering.h"
#include "environment/sky/sky_table.h"
#include "tests/environment/light_sums.h"
#include "tests/environment/traced_photons.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace lambent::environment {
namespace {

using testing::degree;
using testing::luminance;
using testing::pi;
using testing::Vec;

constexpr double nits = static_cast<double>(sky_nits_per_unit);
constexpr int width = 128;

// With the sun at camera azimuth 0, which is +Z. Made once for all tests.
const image::RadianceImage& sky_at(double elevation_degrees, float turbidity = 2.2f)
{
    static std::map<std::pair<double, float>, image::RadianceImage> skies;
    image::RadianceImage& sky = skies[{elevation_degrees, turbidity}];
    if (sky.values.empty())
        sky = make_sky({width, 0.0f, static_cast<float>(elevation_degrees * degree), turbidity});
    return sky;
}

// On a surface facing the sun, lux.
double direct_illuminance(double elevation, double turbidity)
{
    const Rgb c = ClearSky(elevation, turbidity).sun_illuminance();
    return luminance(&c.r);
}

// On a level surface from the sky without the sun, lux.
double diffuse_illuminance(double elevation_degrees, float turbidity = 2.2f)
{
    const double elevation = elevation_degrees * degree;
    const double all = nits * testing::irradiance(sky_at(elevation_degrees, turbidity), {0.0, 1.0, 0.0});
    const double sun =
        elevation > 0.0 ? std::sin(elevation) * direct_illuminance(elevation, static_cast<double>(turbidity))
                        : 0.0;
    return all - sun;
}

double sky_luminance(const ClearSky& sky, const SkyLight& light, double elevation, double cosine)
{
    const double air = air_phase(cosine), haze = haze_phase(cosine, sky.ring(elevation));
    return air * luminance(&light.air.r) + haze * luminance(&light.haze.r) + luminance(&light.even.r);
}

TEST(SkyTable, AgreesWithTheSkyItStandsFor)
{
    double worst = 0.0;
    std::mt19937 random(6);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    const SkyTableSize size;
    for (const double sun : {-0.06, 0.03, 0.7})
        for (const double turbidity : {2.2, 8.0}) {
            const ClearSky sky(sun, turbidity);
            const SkyTable table(sky);
            for (int i = 0; i < 150; ++i) {
                // Half of them close to the ground's edge.
                const double t = 2.0 * share(random) - 1.0;
                const double elevation = i % 2 == 0 ? 0.5 * pi * t : sky.ground_edge() + 0.2 * t * t * t;
                const double from_sun = pi * share(random), place = from_sun / pi * (size.angles - 1);
                const int angle = static_cast<int>(place);
                const double cosine = std::sin(elevation) * std::sin(sun) +
                                      std::cos(elevation) * std::cos(sun) * std::cos(from_sun);
                const SkyLight light =
                    between(table.row(elevation), angle, static_cast<float>(place - angle));
                const double truth = sky_luminance(sky, sky.light(elevation, from_sun), elevation, cosine);
                const double error = sky_luminance(sky, light, elevation, cosine) / truth - 1.0;
                worst = std::max(worst, std::fabs(error));
                EXPECT_NEAR(error, 0.0, 0.015) << sun << ' ' << elevation << ' ' << from_sun;
            }
        }
    std::printf("worst error of the table's luminance: %.2f %%\n", 100.0 * worst);
}

// [IES Calculation Procedures Committee 1984, clear sky: direct 127.5 e^(-0.21 / sin), diffuse 0.8 + 15.5 sin^0.5, klx]
TEST(Sky, IlluminancesAreThoseOfAClearDay)
{
    for (const int elevation : {20, 45, 60}) {
        const double sine = std::sin(elevation * degree);
        const double direct = direct_illuminance(elevation * degree, 2.2),
                     diffuse = diffuse_illuminance(elevation);
        std::printf("sun at %d: direct %.1f klx, diffuse %.1f klx\n", elevation, direct / 1000,
                    diffuse / 1000);
        EXPECT_NEAR(direct / (127.5e3 * std::exp(-0.21 / sine)), 1.0, 0.1) << elevation;
        EXPECT_NEAR(diffuse / (800.0 + 15500.0 * std::sqrt(sine)), 1.0, 0.3) << elevation;
    }
}

// Diffuse light of air, haze and ground at all wavelengths. The tracer's own noise is below 1 %; it takes the earth for
// flat, which tells when the sun is much lower than here.
TEST(Sky, DiffuseLightIsThatOfTracedPhotons)
{
    struct Day {
        int elevation;
        float turbidity;
    };
    for (const Day day : {Day{20, 2.2f}, Day{60, 2.2f}, Day{60, 6.0f}}) {
        const Spectrum clear = Atmosphere(1.0).transmittance({0.0, 1.0});
        Spectrum arrived;
        for (int i = 0; i < band_count; ++i) {
            const double um = band_wavelengths[static_cast<std::size_t>(i)] / 1000.0,
                         inverse = 1.0 / (um * um);
            const double air =
                0.008569 * inverse * inverse * (1.0 + 0.0113 * inverse + 0.00013 * inverse * inverse);
            const double haze =
                (static_cast<double>(day.turbidity) - 1.0) * 0.0973 * std::pow(um / 0.55, -1.3);
            const double ozone = std::max(0.0, -std::log(static_cast<double>(clear[i])) - air);
            testing::PhotonTracer tracer({air, haze, ozone, static_cast<double>(ground_albedo()[i])});
            arrived[i] = static_cast<float>(tracer.diffuse_share(day.elevation * degree, 12000));
        }
        const Rgb c = sunlight_rgb(arrived);
        const double traced = std::sin(day.elevation * degree) * luminance(&c.r);
        const double ratio = diffuse_illuminance(day.elevation, day.turbidity) / traced;
        std::printf("sun at %d, turbidity %.1f: diffuse light is %.3f of the traced\n", day.elevation,
                    static_cast<double>(day.turbidity), ratio);
        EXPECT_NEAR(ratio, 1.0, 0.05);
    }
}

// [Karayel, Navvab, Ne'eman and Selkowitz 1984, "Zenith luminance and sky luminance distributions for daylighting
// calculations": (1.376 T - 1.81) tan + 0.38 kcd/m^2, for Linke's turbidity, 2.75 on a clear day]
TEST(Sky, TheZenithIsAsBrightAsMeasured)
{
    for (const int elevation : {20, 45, 60}) {
        const double measured = 1000.0 * ((1.376 * 2.75 - 1.81) * std::tan(elevation * degree) + 0.38);
        const double zenith = nits * luminance(testing::texel_towards(sky_at(elevation), {0.0, 1.0, 0.01}));
        std::printf("sun at %d: zenith %.0f nits, measured %.0f\n", elevation, zenith, measured);
        EXPECT_NEAR(zenith / measured, 1.0, 0.25) << elevation;
    }
}

// [Glossary of Meteorology, "civil twilight": 585 to 410 lx at sunset, which refraction delays to -0.8 degrees, 3.5 to
// 2 lx at -6 degrees]
TEST(Sky, TwilightIsAboutAsBrightAsMeasured)
{
    const double sunset = diffuse_illuminance(-0.8), dusk = diffuse_illuminance(-5.7);
    std::printf("sun at -0.8 degrees: %.0f lx, at -5.7: %.1f lx\n", sunset, dusk);
    EXPECT_GT(sunset, 300.0);
    EXPECT_LT(sunset, 1000.0);
    EXPECT_GT(dusk, 2.0);
    EXPECT_LT(dusk, 12.0);
}

TEST(Sky, GetsBrighterWithTheSunAndWithHaze)
{
    const double elevations[] = {-5.7, -0.8, 0.0, 20.0, 45.0, 60.0};
    for (std::size_t i = 1; i < std::size(elevations); ++i)
        EXPECT_GT(diffuse_illuminance(elevations[i]), 1.05 * diffuse_illuminance(elevations[i - 1]));
    EXPECT_GT(diffuse_illuminance(60, 6.0f), 1.3 * diffuse_illuminance(60));
    EXPECT_LT(direct_illuminance(60 * degree, 6.0), 0.85 * direct_illuminance(60 * degree, 2.2));
    for (const double turbidity : {1.5, 3.0, 10.0})
        EXPECT_LT(direct_illuminance(0.1, turbidity), 0.7 * direct_illuminance(0.3, turbidity));
}

TEST(Sky, HasTheColoursOfDayAndOfSunset)
{
    const auto blue_to_red = [](const image::RadianceImage& sky, const Vec& direction) {
        const float* texel = testing::texel_towards(sky, direction);
        return texel[2] / texel[0];
    };
    const Vec zenith = {0.0, 1.0, -0.01}, away = {0.0, 0.7, -0.7}, low = {0.0, 0.07, -1.0};
    EXPECT_GT(blue_to_red(sky_at(45), zenith), 1.6f);
    EXPECT_GT(blue_to_red(sky_at(45), away), 2.0f) << "deepest across from the sun";
    EXPECT_LT(blue_to_red(sky_at(45), low), 0.8f * blue_to_red(sky_at(45), away)) << "pale at the horizon";
    EXPECT_LT(blue_to_red(sky_at(60, 6.0f), away), blue_to_red(sky_at(60), away)) << "paler in haze";
    EXPECT_LT(blue_to_red(sky_at(0), {0.3, 0.04, 1.0}), 0.8f) << "red around the setting sun";
    EXPECT_GT(blue_to_red(sky_at(0), zenith), 1.1f);
    const Rgb low_sun = ClearSky(0.02, 2.2).sun_illuminance(),
              high_sun = ClearSky(1.0, 2.2).sun_illuminance();
    EXPECT_GT(low_sun.r, 4.0f * low_sun.b);
    EXPECT_NEAR(high_sun.r / high_sun.b, 1.15f, 0.2f);
}

// Both halves are alike, and away from the sun no row leaps from those beside it but at the horizon.
TEST(Sky, HasNoSeamsOrSteps)
{
    const image::RadianceImage sky = make_sky({256, 1.5707964f, 0.4f, 2.2f}); // sun in the middle, at +X
    const int last = sky.width - 1;
    for (int y = 0; y < sky.height; ++y) {
        ASSERT_NEAR(sky.pixel(0, y)[1] / sky.pixel(last, y)[1], 1.0f, 1e-3f) << "row " << y;
        ASSERT_NEAR(sky.pixel(100, y)[1] / sky.pixel(last - 100, y)[1], 1.0f, 1e-3f) << "row " << y;
    }
    for (int y = 1; y + 1 < sky.height; ++y)
        if (std::abs(y - sky.height / 2) > 3) {
            const double above = luminance(sky.pixel(0, y - 1)), here = luminance(sky.pixel(0, y)),
                         below = luminance(sky.pixel(0, y + 1));
            ASSERT_NEAR((above + below) / (2.0 * here), 1.0, 0.01) << "row " << y;
        }
}

TEST(Sky, TurnsWithTheSunAsACameraDoes)
{
    const image::RadianceImage& sky = sky_at(45);
    const Vec suns[] = {
        {0, 1, 1}, {1, 1, 0}, {0, 1, -1}, {-1, 1, 0}}; // azimuth 0 is +Z, a quarter more is +X
    for (int k = 0; k < 4; ++k) {
        const float azimuth = static_cast<float>(0.5 * pi * k), elevation = static_cast<float>(45 * degree);
        const image::RadianceImage turned = make_sky({width, azimuth, elevation, 2.2f});
        const Vec brightest = testing::brightest_direction(turned);
        EXPECT_GT(testing::dot(brightest, testing::normalized(suns[k])), std::cos(1.5 * 2.0 * pi / width));
        // A camera's azimuth grows to the left of the panorama.
        for (int y = 0; y < sky.height; ++y)
            for (int x = 0; x < width; ++x) {
                const double expected = luminance(sky.pixel((x + k * width / 4) % width, y));
                ASSERT_NEAR(luminance(turned.pixel(x, y)) / expected, 1.0, 1e-4) << x << ' ' << y;
            }
    }
}

TEST(Sky, TheGroundIsLitAndASunkenSunIsNot)
{
    const double ground = luminance(testing::texel_towards(sky_at(45), {0.01, -1.0, 0.0})) * nits;
    const double level =
        diffuse_illuminance(45) + std::sin(45 * degree) * direct_illuminance(45 * degree, 2.2);
    EXPECT_NEAR(ground * pi / level, 0.215, 0.015) << "albedo of the ground";
    const image::RadianceImage& dusk = sky_at(-5.7);
    double most = 0.0;
    for (const float value : dusk.values)
        most = std::max(most, static_cast<double>(value));
    EXPECT_LT(most * nits, 2000.0) << "no disc below the horizon";
}

} // namespace
} // namespace lambent::environment
