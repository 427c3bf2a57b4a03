// Panoramas made for the tests, and integrals over them in double, straight from the texels.
#pragma once

#include "environment/panorama.h"

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

/// A grey panorama of a function of direction, averaged over 4x4 points per texel.
inline Panorama panorama_of(int width, const std::function<double(const Vec&)>& radiance)
{
    const int height = width / 2, fine = 4;
    image::RadianceImage image{width, height, 3, {}};
    image.values.resize(static_cast<std::size_t>(width * height) * 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double sum = 0.0;
            for (int j = 0; j < fine; ++j)
                for (int i = 0; i < fine; ++i)
                    sum += radiance(texel_direction(width, height, x + (i + 0.5) / fine - 0.5,
                                                    y + (j + 0.5) / fine - 0.5));
            for (int c = 0; c < 3; ++c)
                image.pixel(x, y)[c] = static_cast<float>(sum / (fine * fine));
        }
    return make_panorama(image);
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

/// Sum over all texels of radiance (red) times weight(direction) times solid angle.
inline double integral(const Panorama& p, const std::function<double(const Vec&)>& weight)
{
    double sum = 0.0;
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x)
            sum += static_cast<double>(p.radiance(x, y).r) *
                   weight(texel_direction(p.width, p.height, x, y)) * texel_area(p.width, p.height, y);
    return sum;
}

} // namespace lambent::environment::testing
