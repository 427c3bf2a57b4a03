// Deterministic noise, the same on every machine.
#pragma once

#include <cstdint>

namespace lambent::kitchen {

/// A hash of two numbers in [0, 1).
float hashed(std::uint32_t a, std::uint32_t b);

/// Value noise in [-1, 1]: lattice values interpolated by quintics [Perlin 2002]. It repeats after `period_x`,
/// `period_y` lattice cells (1 or more).
struct NoiseLattice {
    int period_x = 1, period_y = 1;
    std::uint32_t seed = 0;
};
float value_noise(float x, float y, const NoiseLattice& lattice);

/// A sum of octaves of value noise, each with twice the frequency and half the amplitude; repeats with period 1; about
/// -1 to 1.
float fractal_noise(float u, float v, NoiseLattice lattice, int octaves);

} // namespace lambent::kitchen
