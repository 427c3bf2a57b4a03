// Pictures whose truth is a formula, and estimates of it with noise of a known size.
#pragma once

#include "audit/audit.h"
#include "base/hash.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace lambent::audit::testing {

/// A number from 0 to 1, exclusive, independent for each x, y and seed.
inline double uniform(int x, int y, std::uint32_t seed)
{
    return (hashed(hashed(hashed(static_cast<std::uint32_t>(x), 77), static_cast<std::uint32_t>(y)), seed) +
            0.5) *
           0x1p-32;
}

/// A standard normal one. [Box and Muller 1958]
inline double normal(int x, int y, std::uint32_t seed)
{
    return std::sqrt(-2.0 * std::log(uniform(x, y, seed))) *
           std::cos(2.0 * std::numbers::pi * uniform(x, y, hashed(seed, 1)));
}

/// A grey value by pixel.
using Grey = std::function<double(int, int)>;

/// All pixels covered.
inline image::RadianceImage picture_of(int width, int height, const Grey& value)
{
    image::RadianceImage picture = image::black_image(width, height, 4);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < 3; ++c)
                picture.pixel(x, y)[c] = static_cast<float>(value(x, y));
            picture.pixel(x, y)[3] = 1.0f;
        }
    return picture;
}

/// Estimates of `truth` with normal noise of this standard deviation at 128 samples, the same in all channels.
inline PixelLight noisy(const Grey& truth, double noise)
{
    return [=](const reference::PixelTracer::Pixel& p) {
        const double deviation = noise * std::sqrt(128.0 / p.samples);
        return reference::PixelEstimate{glm::dvec3(truth(p.x, p.y) + deviation * normal(p.x, p.y, p.seed)),
                                        glm::dvec3(deviation * deviation), 1.0, 0};
    };
}

} // namespace lambent::audit::testing
