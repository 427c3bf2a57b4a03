// Pictures by formula, for anyone to make again.
#pragma once

#include "image/image.h"

#include <cmath>

namespace lambent::compare::test {

inline image::RadianceImage constant(int width, int height, const float (&rgb)[3])
{
    image::RadianceImage picture{width, height, 3, {}};
    for (int i = 0; i < width * height; ++i)
        picture.values.insert(picture.values.end(), rgb, rgb + 3);
    return picture;
}

/// Waves in red and green and a disc with stripes in blue, all codes from 0.05 to 0.95; with another phase, about the
/// same picture.
inline image::RadianceImage waves(int width, int height, double phase)
{
    image::RadianceImage picture{width, height, 3, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool inside = std::hypot(x - 0.5 * width, y - 0.5 * height) < height / 3.0 + 2.0 * phase;
            const double rgb[3] = {0.5 + 0.4 * std::sin(0.21 * x + phase) * std::cos(0.13 * y),
                                   0.5 + 0.45 * std::sin(0.05 * x + 0.09 * y - phase),
                                   (inside ? 0.85 : 0.2) + 0.1 * std::cos(0.4 * x)};
            for (const double value : rgb)
                picture.values.push_back(static_cast<float>(value));
        }
    return picture;
}

/// Light of several stops: 40 times the sixth power of the waves.
inline image::RadianceImage bright_waves(int width, int height, double phase)
{
    image::RadianceImage picture = waves(width, height, phase);
    for (float& value : picture.values)
        value = static_cast<float>(40.0 * std::pow(static_cast<double>(value), 6.0));
    return picture;
}

} // namespace lambent::compare::test
