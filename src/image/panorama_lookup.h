// Bilinear lookups in equirectangular images.
#pragma once

#include "image/panorama_rows.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace lambent::image {

struct PanoramaTexel {
    int x, y;
};

/// The texel at column x and row y, which may lie outside the image: columns wrap around, and up to `height` rows
/// beyond a pole the image continues half a turn away. With an odd number of columns, half a turn is rounded down to
/// whole columns.
inline PanoramaTexel texel_across(int x, int y, int width, int height)
{
    if (y < 0 || y >= height) {
        y = y < 0 ? -1 - y : 2 * height - 1 - y;
        x += width / 2;
    }
    if (x < 0 || x >= width)
        x = (x % width + width) % width;
    return {x, y};
}

/// The columns on either side of u (0 to 1). They range from -1 to `width`.
inline Neighbours columns_around(double u, int width)
{
    const double x = u * width - 0.5, left = std::floor(x);
    const int first = static_cast<int>(left);
    return {first, first + 1, x - left};
}

/// RGB interpolated linearly between two columns and two rows of a panorama. `texel(x, y)` returns three values that
/// can be indexed.
template <class Texel>
std::array<double, 3> bilinear(const Neighbours& columns, const Neighbours& rows, int width, int height,
                               const Texel& texel)
{
    const auto at = [&](int x, int y) {
        const PanoramaTexel inside = texel_across(x, y, width, height);
        return texel(inside.x, inside.y);
    };
    const auto a = at(columns.first, rows.first), b = at(columns.second, rows.first);
    const auto c = at(columns.first, rows.second), d = at(columns.second, rows.second);
    std::array<double, 3> rgb;
    for (std::size_t k = 0; k < 3; ++k) {
        const double upper = static_cast<double>(a[k]) + columns.share * static_cast<double>(b[k] - a[k]);
        const double lower = static_cast<double>(c[k]) + columns.share * static_cast<double>(d[k] - c[k]);
        rgb[k] = upper + rows.share * (lower - upper);
    }
    return rgb;
}

} // namespace lambent::image
