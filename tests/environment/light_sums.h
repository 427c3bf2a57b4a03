// Sums over the texels of a picture of all directions, in double.
#pragma once

#include "image/image.h"
#include "tests/environment/test_panoramas.h"

#include <cmath>
#include <numbers>

namespace lambent::environment::testing {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180.0;

inline double luminance(double r, double g, double b)
{
    return 0.2126 * r + 0.7152 * g + 0.0722 * b; // IEC 61966-2-1
}

inline double luminance(const float* rgb)
{
    return luminance(static_cast<double>(rgb[0]), static_cast<double>(rgb[1]), static_cast<double>(rgb[2]));
}

/// Calls visit(rgb, direction, solid angle) for every texel.
template <class Visit>
void for_each_texel(const image::RadianceImage& image, Visit&& visit)
{
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            visit(image.pixel(x, y), texel_direction(image.width, image.height, x, y),
                  texel_area(image.width, image.height, y));
}

/// Light (as luminance) that a surface facing `normal` gets from all texels.
inline double irradiance(const image::RadianceImage& image, const Vec& normal)
{
    double sum = 0.0;
    for_each_texel(image, [&](const float* rgb, const Vec& d, double area) {
        sum += luminance(rgb) * std::max(dot(d, normal), 0.0) * area;
    });
    return sum;
}

/// The texel in a direction.
inline const float* texel_towards(const image::RadianceImage& image, const Vec& direction)
{
    const Vec d = normalized(direction);
    const double column = (std::atan2(d[2], d[0]) / (2.0 * pi) + 0.5) * image.width;
    const double row = std::acos(d[1]) / pi * image.height;
    return image.pixel(std::min(static_cast<int>(column), image.width - 1),
                       std::min(static_cast<int>(row), image.height - 1));
}

/// Direction of the texel of most luminance.
inline Vec brightest_direction(const image::RadianceImage& image)
{
    double most = -1.0;
    Vec brightest{};
    for_each_texel(image, [&](const float* rgb, const Vec& d, double) {
        if (luminance(rgb) > most) {
            most = luminance(rgb);
            brightest = d;
        }
    });
    return brightest;
}

} // namespace lambent::environment::testing
