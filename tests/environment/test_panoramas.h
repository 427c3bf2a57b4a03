// Panoramas made for the tests, and integrals over them in double, straight from the texels.
#pragma once

#include "environment/panorama/panorama.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace lambent::environment::testing {

using Vec = std::array<double, 3>;

inline double dot(const Vec& a, const Vec& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vec normalized(const Vec& a)
{
    const double length = std::sqrt(dot(a, a));
    return {a[0] / length, a[1] / length, a[2] / length};
}

/// Direction of the middle of a texel, from the documented orientation alone: the middle column is +X, +Z lies a
/// quarter to the right of it, the first row is at +Y.
inline Vec texel_direction(int width, int height, double x, double y)
{
    const double phi = ((x + 0.5) / width - 0.5) * 2.0 * std::numbers::pi;
    const double theta = (y + 0.5) / height * std::numbers::pi;
    return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

inline double texel_area(int width, int height, int y)
{
    const double step = std::numbers::pi / height;
    return 2.0 * std::numbers::pi / width * (std::cos(y * step) - std::cos((y + 1) * step));
}

/// A panorama of a function of direction that returns (r, g, b), averaged over 4x4 points per texel.
inline Panorama coloured_panorama_of(int width, const std::function<Vec(const Vec&)>& radiance)
{
    const int height = width / 2, fine = 4;
    image::RadianceImage image{width, height, 3, {}};
    image.values.resize(static_cast<std::size_t>(width * height) * 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            Vec sum = {0.0, 0.0, 0.0};
            for (int j = 0; j < fine; ++j)
                for (int i = 0; i < fine; ++i) {
                    const Vec light = radiance(texel_direction(width, height, x + (i + 0.5) / fine - 0.5,
                                                               y + (j + 0.5) / fine - 0.5));
                    for (std::size_t c = 0; c < 3; ++c)
                        sum[c] += light[c];
                }
            for (std::size_t c = 0; c < 3; ++c)
                image.pixel(x, y)[c] = static_cast<float>(sum[c] / (fine * fine));
        }
    return make_panorama(image);
}

/// Grey.
inline Panorama panorama_of(int width, const std::function<double(const Vec&)>& radiance)
{
    return coloured_panorama_of(width, [&](const Vec& d) {
        const double light = radiance(d);
        return Vec{light, light, light};
    });
}

/// The hard case: a sun of the given radiance and 0.53 degrees across in a dim sky.
inline Panorama sunny_panorama(int width, const Vec& sun, double sun_radiance = 50000.0)
{
    const double edge = std::cos(0.265 * std::numbers::pi / 180.0);
    return panorama_of(width, [=](const Vec& d) {
        const double sky = d[1] > 0.0 ? 0.6 + 0.4 * d[1] : 0.25;
        return dot(d, sun) > edge ? sun_radiance : sky;
    });
}

/// Nothing but that sun.
inline Panorama lone_sun_panorama(int width, const Vec& sun, double sun_radiance = 50000.0)
{
    const double edge = std::cos(0.265 * std::numbers::pi / 180.0);
    return panorama_of(width, [=](const Vec& d) { return dot(d, sun) > edge ? sun_radiance : 0.0; });
}

/// A channel, 0 to 2, of a texel.
inline double radiance_of(const Panorama& p, int x, int y, std::size_t channel)
{
    const Rgb c = p.radiance(x, y);
    return static_cast<double>(channel == 0 ? c.r : channel == 1 ? c.g : c.b);
}

/// Sum over all texels of radiance times weight(direction) times solid angle.
inline double integral(const Panorama& p, const std::function<double(const Vec&)>& weight,
                       std::size_t channel = 0)
{
    double sum = 0.0;
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x)
            sum += radiance_of(p, x, y, channel) * weight(texel_direction(p.width, p.height, x, y)) *
                   texel_area(p.width, p.height, y);
    return sum;
}

/// The integral of light times direction.
inline Vec moment(const Panorama& p, std::size_t channel = 0)
{
    Vec sum;
    for (std::size_t axis = 0; axis < 3; ++axis)
        sum[axis] = integral(
            p, [axis](const Vec& d) { return d[axis]; }, channel);
    return sum;
}

/// Light of up to second order in the direction, each channel its own: a + b.d + d.M d, M symmetric. Its irradiance is
/// known: the clamped cosine keeps pi of the constant, 2 pi / 3 of the first order and pi / 4 of the second.
/// [Ramamoorthi and Hanrahan 2001, eq. 9]
struct Quadratic {
    double constant;
    Vec first;
    double xx, yy, zz, xy, xz, yz;

    double second(const Vec& d) const
    {
        return xx * d[0] * d[0] + yy * d[1] * d[1] + zz * d[2] * d[2] + xy * d[0] * d[1] + xz * d[0] * d[2] +
               yz * d[1] * d[2];
    }
    double radiance(const Vec& d) const { return constant + dot(first, d) + second(d); }
    double irradiance(const Vec& n) const
    {
        const double mean = (xx + yy + zz) / 3.0; // of the second order's own part, which is constant light
        return std::numbers::pi * (constant + mean + 2.0 / 3.0 * dot(first, n) + 0.25 * (second(n) - mean));
    }
};

/// No two channels, axes or signs alike; nowhere negative.
constexpr Quadratic coloured_light[3] = {
    {2.0, {0.0, 1.0, 0.0}, 0.0, 0.3, 0.0, 0.0, -0.5, 0.0},
    {2.0, {-0.8, 0.0, 0.2}, 0.0, 0.0, 0.0, 0.0, 0.0, 0.6},
    {1.5, {0.0, -0.3, 0.7}, -0.3, 0.0, 0.2, 0.4, 0.0, 0.0},
};

inline Panorama coloured_panorama(int width)
{
    return coloured_panorama_of(width, [](const Vec& d) {
        return Vec{coloured_light[0].radiance(d), coloured_light[1].radiance(d),
                   coloured_light[2].radiance(d)};
    });
}

} // namespace lambent::environment::testing
