#include "environment/sky/sky_light.h"

#include "environment/sky/march.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::environment {
namespace {

// Altitude of the viewer, km: high enough for the ground's edge to lie in the haze.
constexpr double viewer_altitude = 0.3;

constexpr int steps = 32;

// Two lobes of equal weight; the sharp one makes the bright ring around the sun.
constexpr double broad_lobe = 0.5;
constexpr double sharp_lobe = 0.9;
static_assert(0.5 * (broad_lobe + sharp_lobe) == Atmosphere::haze_mean_cosine);

double henyey_greenstein(double g, double cosine)
{
    const double square = 1.0 + g * g - 2.0 * g * cosine;
    return (1.0 - g * g) / (4.0 * std::numbers::pi * square * std::sqrt(square));
}

constexpr int irradiance_heights = 24;
constexpr int irradiance_sides = 16;

} // namespace

double air_phase(double cosine)
{
    return 3.0 / (16.0 * std::numbers::pi) * (1.0 + cosine * cosine);
}

double haze_phase(double cosine, double ring)
{
    return 0.5 * (henyey_greenstein(broad_lobe, cosine) + ring * henyey_greenstein(sharp_lobe, cosine));
}

// SkyLight in bands, and the transmittance of the path.
struct ClearSky::Scattered {
    Spectrum air, haze, even, passed;
};

ClearSky::ClearSky(double sun_elevation, double turbidity)
    : atmosphere_(turbidity),
      multiple_(atmosphere_, sun_elevation), towards_sun_{viewer_altitude, std::sin(sun_elevation)}
{
    const Ray from_ground{0.0, std::max(0.0, towards_sun_.cosine)};
    const float direct = static_cast<float>(from_ground.cosine * visible_sun(from_ground));
    const Spectrum irradiance = direct * atmosphere_.transmittance(from_ground) + sky_irradiance();
    ground_ = static_cast<float>(1.0 / std::numbers::pi) * (ground_albedo() * irradiance);
}

ClearSky::Scattered ClearSky::scattered(const Ray& ray, double between_cosine, double length) const
{
    Scattered sum;
    const auto visit = [&](double distance, const Ray& point, const Densities& d, const Spectrum& weight) {
        const Ray sun = sun_from(towards_sun_, between_cosine, distance, point.altitude);
        const Spectrum deflected = atmosphere_.air_scattering(d) + atmosphere_.haze_deflection(d);
        const Spectrum air = weight * atmosphere_.air_scattering(d);
        const Spectrum haze = weight * atmosphere_.haze_scattering(d);
        const Spectrum sunlight = sunlight_at(atmosphere_, sun);
        sum.air += air * sunlight;
        sum.haze += haze * sunlight;
        sum.even += weight * deflected * multiple_.arriving(sun);
    };
    sum.passed = march(atmosphere_, ray, length, steps, visit);
    return sum;
}

// Irradiance of a horizontal surface, by directions that have equal weights under a uniform sky.
Spectrum ClearSky::sky_irradiance() const
{
    const double sun_cosine = towards_sun_.cosine, sun_sine = std::sqrt(1.0 - sun_cosine * sun_cosine);
    const auto add = [&](int i, Spectrum sum) {
        const int height = i / irradiance_sides;
        const double sine = std::sqrt((height + 0.5) / irradiance_heights);
        const double side = (i % irradiance_sides + 0.5) * std::numbers::pi / irradiance_sides;
        const Ray ray{viewer_altitude, std::sqrt(1.0 - sine * sine)};
        const double between = ray.cosine * sun_cosine + sine * sun_sine * std::cos(side);
        const Scattered s = scattered(ray, between, distance_to_space(ray));
        return sum + static_cast<float>(air_phase(between)) * s.air +
               static_cast<float>(haze_phase(between, ring(std::acos(sine)))) * s.haze + s.even;
    };
    constexpr int count = irradiance_heights * irradiance_sides;
    using Range = tbb::blocked_range<int>;
    const Spectrum sum = tbb::parallel_deterministic_reduce(
        Range(0, count, irradiance_sides), Spectrum{},
        [&](const Range& range, Spectrum part) {
            for (int i = range.begin(); i < range.end(); ++i)
                part = add(i, part);
            return part;
        },
        [](const Spectrum& a, const Spectrum& b) { return a + b; });
    return static_cast<float>(std::numbers::pi / count) * sum;
}

SkyLight ClearSky::light(double elevation, double from_sun) const
{
    const Ray ray{viewer_altitude, std::sin(elevation)};
    const double sun_sine = std::sqrt(1.0 - towards_sun_.cosine * towards_sun_.cosine);
    const double between =
        ray.cosine * towards_sun_.cosine + std::cos(elevation) * sun_sine * std::cos(from_sun);
    const bool down = elevation < ground_edge();
    Scattered s = scattered(ray, between, down ? distance_to_ground(ray) : distance_to_space(ray));
    if (down)
        s.even += s.passed * ground_;
    return {sunlight_rgb(s.air), sunlight_rgb(s.haze), sunlight_rgb(s.even)};
}

double ClearSky::ring(double elevation) const
{
    const double lowest = horizon_cosine(viewer_altitude);
    const double seen = atmosphere_.forward_depth({viewer_altitude, std::max(std::sin(elevation), lowest)});
    const double sun = atmosphere_.forward_depth({viewer_altitude, std::max(towards_sun_.cosine, lowest)});
    const double depth = 0.5 * (seen + sun);
    return -std::expm1(-depth) / depth;
}

Rgb ClearSky::sun_illuminance() const
{
    const double cosine = std::max(towards_sun_.cosine, horizon_cosine(viewer_altitude));
    return sunlight_rgb(atmosphere_.transmittance({viewer_altitude, cosine}));
}

double ClearSky::ground_edge() const
{
    return std::asin(horizon_cosine(viewer_altitude));
}

} // namespace lambent::environment
