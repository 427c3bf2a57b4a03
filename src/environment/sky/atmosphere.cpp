#include "environment/sky/atmosphere.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::environment {
namespace {

// Scale heights of air and continental haze. [Bruneton and Neyret 2008, "Precomputed atmospheric scattering", sec. 2]
constexpr double air_height = 8.0;
constexpr double haze_height = 1.2;

// Ozone: none at 10 km, most at 25 km, none at 40 km. [Bruneton 2017, "A qualitative and quantitative evaluation of 8
// clear sky models"]
constexpr double ozone_peak = 25.0;
constexpr double ozone_half_width = 15.0;
// 300 Dobson units of 2.687e20 molecules per m^2, here per cm^2.
constexpr double ozone_column = 300.0 * 2.687e16;
// cm^2, at 233 K, means over the bands. [Serdyuchenko et al. 2014, "High spectral resolution ozone absorption
// cross-sections", part 2]
constexpr std::array<double, band_count> ozone_cross_section = {1.31e-23,  1.324e-22, 6.34e-22,  1.994e-21,
                                                                3.882e-21, 4.606e-21, 2.964e-21, 1.369e-21};

// Optical depth of haze falls as wavelength^-1.3, as is usual on clear days. [Angstrom 1929]
constexpr double haze_exponent = 1.3;
// Single scattering albedo of average continental aerosol, of which haze_mean_cosine is too. [Hess, Koepke and Schult
// 1998, "Optical properties of aerosols and clouds", table 4]
constexpr float haze_albedo = 0.925f;

// Share of the light scattered by haze that counts as not deflected. [Joseph et al. 1976, eq. 5]
constexpr float forward_share =
    static_cast<float>(Atmosphere::haze_mean_cosine * Atmosphere::haze_mean_cosine);

// Vertical optical depth of air at sea level. [Bodhaine et al. 1999, "On Rayleigh optical depth calculations", eq. 30]
double air_depth(double micrometres)
{
    const double square = micrometres * micrometres;
    return 0.0021520 * (1.0455996 - 341.29061 / square - 0.90230850 * square) /
           (1.0 + 0.0027059889 / square - 85.968563 * square);
}

// The table's axes are those of Bruneton and Neyret 2008, sec. 4: the square root of altitude, and the length of the
// path within the atmosphere, between the shortest (straight up) and the longest (tangent to the ground).
constexpr int table_altitudes = 32;
constexpr int table_lengths = 64;
constexpr int column_steps = 64;

struct PathLengths {
    double shortest, longest;
};

PathLengths path_lengths(double altitude)
{
    return {Atmosphere::height - altitude, distance_to_space({altitude, horizon_cosine(altitude)})};
}

} // namespace

Atmosphere::Atmosphere(double turbidity)
{
    const double haze_at_550 = (turbidity - 1.0) * air_depth(0.55);
    for (int i = 0; i < band_count; ++i) {
        const double nm = band_wavelengths[static_cast<std::size_t>(i)];
        const double haze = haze_at_550 * std::pow(nm / 550.0, -haze_exponent);
        air_[i] = static_cast<float>(air_depth(nm / 1000.0) / air_height);
        haze_extinction_[i] = static_cast<float>(haze / haze_height);
        ozone_absorption_[i] = static_cast<float>(ozone_cross_section[static_cast<std::size_t>(i)] *
                                                  ozone_column / ozone_half_width);
    }
    haze_ = haze_albedo * haze_extinction_;
    fill_table();
}

Densities Atmosphere::densities(double altitude) const
{
    return {std::exp(-altitude / air_height), std::exp(-altitude / haze_height),
            std::max(0.0, 1.0 - std::fabs(altitude - ozone_peak) / ozone_half_width)};
}

Spectrum Atmosphere::extinction(const Densities& d) const
{
    return static_cast<float>(d.air) * air_ + static_cast<float>(d.haze) * haze_extinction_ +
           static_cast<float>(d.ozone) * ozone_absorption_;
}

Spectrum Atmosphere::haze_deflection(const Densities& d) const
{
    return (1.0f - forward_share) * haze_scattering(d);
}

Spectrum Atmosphere::deflection(const Densities& d) const
{
    return extinction(d) + -forward_share * haze_scattering(d);
}

Densities Atmosphere::columns(const Ray& ray) const
{
    if (ray.cosine < 0.0) {
        // Down to the lowest point and up again: twice the path from there to space, less the path from the start in
        // the opposite direction.
        const double radius = ground_radius + ray.altitude;
        const double lowest =
            std::max(0.0, radius * std::sqrt(1.0 - ray.cosine * ray.cosine) - ground_radius);
        const Densities half = columns({lowest, 0.0}), back = columns({ray.altitude, -ray.cosine});
        return {2.0 * half.air - back.air, 2.0 * half.haze - back.haze, 2.0 * half.ozone - back.ozone};
    }
    const double length = distance_to_space(ray);
    Densities sum;
    for (int i = 0; i < column_steps; ++i) {
        // Steps grow with distance.
        const double t = (i + 0.5) / column_steps;
        const double step = 2.0 * t * length / column_steps;
        const Densities d = densities(further_along(ray, t * t * length).altitude);
        sum = {sum.air + step * d.air, sum.haze + step * d.haze, sum.ozone + step * d.ozone};
    }
    return sum;
}

Spectrum Atmosphere::transmittance(const Ray& ray) const
{
    return transmitted(extinction(columns(ray)));
}

double Atmosphere::forward_depth(const Ray& ray) const
{
    constexpr int at_560 = 4;
    static_assert(band_wavelengths[at_560] == 560.0);
    return static_cast<double>(forward_share * haze_scattering(columns(ray))[at_560]);
}

void Atmosphere::fill_table()
{
    table_.resize(static_cast<std::size_t>(table_altitudes) * table_lengths);
    tbb::parallel_for(0, table_altitudes, [this](int row) {
        const double t = static_cast<double>(row) / (table_altitudes - 1);
        const double altitude = t * t * height;
        const double radius = ground_radius + altitude, top = ground_radius + height;
        const PathLengths paths = path_lengths(altitude);
        for (int column = 0; column < table_lengths; ++column) {
            const double share = static_cast<double>(column) / (table_lengths - 1);
            const double length = paths.shortest + share * (paths.longest - paths.shortest);
            const double cosine =
                length > 0.0 ? (top * top - radius * radius - length * length) / (2.0 * radius * length)
                             : 1.0;
            table_[static_cast<std::size_t>(row * table_lengths + column)] = transmitted(
                deflection(columns({altitude, std::clamp(cosine, horizon_cosine(altitude), 1.0)})));
        }
    });
}

Spectrum Atmosphere::undeflected(const Ray& ray) const
{
    const PathLengths paths = path_lengths(ray.altitude);
    const double length = std::min(distance_to_space(ray), paths.longest);
    const double share = (length - paths.shortest) / std::max(paths.longest - paths.shortest, 1e-9);
    const double y = std::sqrt(ray.altitude / height) * (table_altitudes - 1);
    const double x = std::clamp(share, 0.0, 1.0) * (table_lengths - 1);
    const int row = std::clamp(static_cast<int>(y), 0, table_altitudes - 2);
    const int column = std::min(static_cast<int>(x), table_lengths - 2);
    const float below = static_cast<float>(y - row), right = static_cast<float>(x - column);
    const Spectrum* at = table_.data() + row * table_lengths + column;
    return (1.0f - below) * ((1.0f - right) * at[0] + right * at[1]) +
           below * ((1.0f - right) * at[table_lengths] + right * at[table_lengths + 1]);
}

Spectrum transmitted(const Spectrum& depth)
{
    Spectrum left;
    for (int i = 0; i < band_count; ++i)
        left[i] = std::exp(-depth[i]);
    return left;
}

double horizon_cosine(double altitude)
{
    const double radius = Atmosphere::ground_radius + altitude;
    const double sine = Atmosphere::ground_radius / radius;
    return -std::sqrt(std::max(0.0, 1.0 - sine * sine));
}

double distance_to_space(const Ray& ray)
{
    const double radius = Atmosphere::ground_radius + ray.altitude;
    const double top = Atmosphere::ground_radius + Atmosphere::height;
    const double along = radius * ray.cosine;
    const double beyond = (top - radius) * (top + radius);
    // The root of t^2 + 2 t along = beyond, without cancellation.
    const double root = std::sqrt(std::max(0.0, along * along + beyond));
    return along > 0.0 ? beyond / (root + along) : root - along;
}

double distance_to_ground(const Ray& ray)
{
    const double radius = Atmosphere::ground_radius + ray.altitude;
    const double along = -radius * ray.cosine;
    const double above = ray.altitude * (Atmosphere::ground_radius + radius);
    return above / (along + std::sqrt(std::max(0.0, along * along - above)));
}

Ray further_along(const Ray& ray, double distance)
{
    const double radius = Atmosphere::ground_radius + ray.altitude;
    const double along = radius * ray.cosine + distance;
    const double squared_change = distance * (2.0 * radius * ray.cosine + distance);
    const double there = std::sqrt(radius * radius + squared_change);
    // The difference of the radii, without cancellation.
    const double altitude = ray.altitude + squared_change / (there + radius);
    return {std::clamp(altitude, 0.0, Atmosphere::height), std::clamp(along / there, -1.0, 1.0)};
}

double visible_sun(const Ray& towards_sun)
{
    const double elevation = std::asin(towards_sun.cosine) - std::asin(horizon_cosine(towards_sun.altitude));
    // Area of a disc to one side of a chord.
    const double x = std::clamp(elevation / sun_radius, -1.0, 1.0);
    return 0.5 + (std::asin(x) + x * std::sqrt(1.0 - x * x)) / std::numbers::pi;
}

} // namespace lambent::environment
