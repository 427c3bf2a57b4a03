#include "environment/sky/multiple_scattering.h"

#include "environment/sky/march.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::environment {
namespace {

constexpr int altitudes = 16;
constexpr int angles = 28;
// Largest angle around the earth, in radians, to the top of the atmosphere as seen from below 1 km.
constexpr double angle_span = 0.18;

constexpr int heights = 16; // directions from a point: so many from down to up,
constexpr int sides = 2;    // each towards the sun and away from it
constexpr int scattering_steps = 8;

constexpr float even = static_cast<float>(0.25 / std::numbers::pi); // phase function of isotropic scattering

// Radiance that arrives at a point from one direction: light scattered once, and the light that would be scattered if
// radiance 1 reached every point of the ray from all directions.
struct Sent {
    Spectrum once, transfer;
};

Sent sent_along(const Atmosphere& atmosphere, const Ray& ray, const Ray& towards_sun, double between_cosine)
{
    const bool meets_ground = ray.cosine < horizon_cosine(ray.altitude);
    const double length = meets_ground ? distance_to_ground(ray) : distance_to_space(ray);
    Sent sent;
    const auto visit = [&](double distance, const Ray& point, const Densities& d, const Spectrum& weight) {
        const Spectrum scattered = weight * (atmosphere.air_scattering(d) + atmosphere.haze_deflection(d));
        const Ray sun = sun_from(towards_sun, between_cosine, distance, point.altitude);
        sent.once += even * (scattered * sunlight_at(atmosphere, sun));
        sent.transfer += scattered;
    };
    const Spectrum passed = march(atmosphere, ray, length, scattering_steps, visit);
    if (meets_ground) {
        const Ray sun = sun_from(towards_sun, between_cosine, length, 0.0);
        const float incidence = static_cast<float>(std::max(0.0, sun.cosine) / std::numbers::pi);
        sent.once += incidence * (passed * ground_albedo() * sunlight_at(atmosphere, sun));
    }
    return sent;
}

Spectrum arriving_at(const Atmosphere& atmosphere, const Ray& towards_sun)
{
    const double sun_sine = std::sqrt(1.0 - towards_sun.cosine * towards_sun.cosine);
    Sent mean;
    for (int i = 0; i < heights; ++i) {
        const Ray ray{towards_sun.altitude, (2 * i + 1.0) / heights - 1.0};
        const double sine = std::sqrt(1.0 - ray.cosine * ray.cosine);
        for (const double side : {-std::numbers::sqrt2 / 2.0, std::numbers::sqrt2 / 2.0}) {
            const double between = ray.cosine * towards_sun.cosine + side * sine * sun_sine;
            const Sent sent = sent_along(atmosphere, ray, towards_sun, between);
            mean.once += sent.once;
            mean.transfer += sent.transfer;
        }
    }
    Spectrum all_orders;
    for (int b = 0; b < band_count; ++b)
        all_orders[b] = mean.once[b] / (static_cast<float>(heights * sides) - mean.transfer[b]);
    return all_orders;
}

} // namespace

const Spectrum& ground_albedo()
{
    static const Spectrum albedo{{0.15f, 0.165f, 0.18f, 0.205f, 0.215f, 0.22f, 0.225f, 0.23f}};
    return albedo;
}

MultipleScattering::MultipleScattering(const Atmosphere& atmosphere, double sun_elevation)
    : first_angle_(0.5 * std::numbers::pi - sun_elevation - angle_span), table_(altitudes * angles)
{
    tbb::parallel_for(0, altitudes * angles, [&](int i) {
        const int altitude = i / angles;
        const double t = static_cast<double>(altitude) / (altitudes - 1);
        const double angle = first_angle_ + 2.0 * angle_span * (i % angles) / (angles - 1);
        table_[static_cast<std::size_t>(i)] =
            arriving_at(atmosphere, {t * t * Atmosphere::height, std::cos(angle)});
    });
}

Spectrum MultipleScattering::arriving(const Ray& towards_sun) const
{
    const double angle = std::acos(towards_sun.cosine);
    const double x = std::clamp((angle - first_angle_) / (2.0 * angle_span), 0.0, 1.0) * (angles - 1);
    const double y = std::sqrt(towards_sun.altitude / Atmosphere::height) * (altitudes - 1);
    const int column = std::min(static_cast<int>(x), angles - 2);
    const int row = std::min(static_cast<int>(y), altitudes - 2);
    const float right = static_cast<float>(x - column), above = static_cast<float>(y - row);
    const Spectrum* at = table_.data() + row * angles + column;
    return (1.0f - above) * ((1.0f - right) * at[0] + right * at[1]) +
           above * ((1.0f - right) * at[angles] + right * at[angles + 1]);
}

} // namespace lambent::environment
