// Evenly distributed random numbers of the samples of a pixel.
#pragma once

#include "base/hash.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace lambent::draw {

/// Samples from this number on fill the cache; no pixel of a picture has as many.
constexpr std::uint32_t first_sample_of_cache = 0x10000;

/// A number in [0, 1) from a 32-bit fraction.
inline float unit_interval(std::uint32_t fraction)
{
    return static_cast<float>(fraction >> 8) * 0x1p-24f;
}

/// Point `index` of a pixel: number `dimension`, 0 to 11, in [0, 1). Multiples of the roots of primes, modulo 1, fill
/// each dimension, and any few together, evenly; a hash of the pixel moves them. [Richtmyer 1951; rotation: Cranley and
/// Patterson 1976]
inline float random_number(std::uint32_t pixel, std::uint32_t index, std::size_t dimension)
{
    // Fractions of sqrt(2), sqrt(3), sqrt(5), sqrt(7) ... times 2^32.
    constexpr std::array<std::uint32_t, 12> steps = {0x6a09e668u, 0xbb67ae86u, 0x3c6ef373u, 0xa54ff53au,
                                                     0x510e5280u, 0x9b05688cu, 0x1f83d9acu, 0x5be0cd19u,
                                                     0xcbbb9d5eu, 0x629a292au, 0x9159015au, 0x152fecd9u};
    return unit_interval(index * steps[dimension] + hashed(pixel, static_cast<std::uint32_t>(dimension)));
}

} // namespace lambent::draw
