// Noise without a seed from outside: the same everywhere, always.
#pragma once

#include <cstdint>

namespace lambent::kitchen {

/// In [0, 1), well mixed from two numbers.
float hashed(std::uint32_t a, std::uint32_t b);

/// Value noise in [-1, 1]: lattice values joined by quintics [Perlin 2002], repeating after `period_x`, `period_y`
/// lattice cells (1 or more).
struct NoiseLattice {
    int period_x = 1, period_y = 1;
    std::uint32_t seed = 0;
};
float value_noise(float x, float y, const NoiseLattice& lattice);

/// Octaves of it, each twice as fine and half as strong, over the unit square, repeating there; about -1 to 1.
float fractal_noise(float u, float v, NoiseLattice lattice, int octaves);

} // namespace lambent::kitchen
