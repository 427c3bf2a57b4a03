// Pictures for the filter: a wall lit through something, with the noise of a few samples.
#pragma once

#include "denoise/light_filter.h"

#include <cstdint>
#include <functional>
#include <random>

namespace lambent::denoise::test {

inline std::size_t index_of(const Picture& picture, int x, int y)
{
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
           static_cast<std::size_t>(x);
}

Rgb filled(std::size_t size, float value);

/// A wall 3 m away that fills the picture, of dull grey, in the dark; 4 samples a pixel.
Picture make_wall(int width, int height);

/// A share of light, in [0, 1], at a pixel.
using Share = std::function<double(int x, int y)>;

/// How samples scatter.
struct Noise {
    std::uint32_t seed = 1;
    double unshadowed = 0.0; ///< samples of unshadowed light are uniform in its mean times 1 -+ this
    /// If not 0, only one of this many samples carries light, that many times as much: a small lamp.
    double rarity = 0.0;
};

/// Fills the halves: each sample carries exact light with its noise, and is blocked except with the given chance; the
/// three channels by the same samples. Blocked samples bring `bounced` light instead.
void sample_light(const Picture& picture, Light& light, const Share& visible, const Noise& noise,
                  double bounced = 0.0);

/// Numbers of every kind in every plane: two depths, three materials, a bent surface, holes, partial coverage, textures,
/// pixels with more samples.
Picture make_mixture(int width, int height, std::uint32_t seed);

/// Root mean square over all pixels and channels.
double rms_difference(const Rgb& a, const std::function<double(int x, int y, int channel)>& b, int width);

} // namespace lambent::denoise::test
