#include "kitchen/model/noise.h"

#include <cmath>

namespace lambent::kitchen {
namespace {

int wrapped(int i, int period)
{
    const int rest = i % period;
    return rest < 0 ? rest + period : rest;
}

float faded(float t)
{
    return t * t * t * (t * (6.0f * t - 15.0f) + 10.0f);
}

} // namespace

float hashed(std::uint32_t a, std::uint32_t b)
{
    // Multiplications and shifts: each bit of the input affects each bit of the output.
    std::uint32_t h = a * 0x9e3779b1u ^ (b + 0x7f4a7c15u) * 0x85ebca77u;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    h ^= h >> 15;
    return static_cast<float>(h >> 8) * 0x1p-24f;
}

float value_noise(float x, float y, const NoiseLattice& lattice)
{
    const float floor_x = std::floor(x), floor_y = std::floor(y);
    const float s = faded(x - floor_x), t = faded(y - floor_y);
    const int x0 = wrapped(static_cast<int>(floor_x), lattice.period_x);
    const int y0 = wrapped(static_cast<int>(floor_y), lattice.period_y);
    const int x1 = wrapped(x0 + 1, lattice.period_x), y1 = wrapped(y0 + 1, lattice.period_y);
    const auto at = [&](int i, int j) {
        return hashed(static_cast<std::uint32_t>(i) + lattice.seed * 7919u, static_cast<std::uint32_t>(j));
    };
    const float upper = std::lerp(at(x0, y0), at(x1, y0), s), lower = std::lerp(at(x0, y1), at(x1, y1), s);
    return 2.0f * std::lerp(upper, lower, t) - 1.0f;
}

float fractal_noise(float u, float v, NoiseLattice lattice, int octaves)
{
    float sum = 0.0f, strength = 0.5f;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += strength * value_noise(u * static_cast<float>(lattice.period_x),
                                      v * static_cast<float>(lattice.period_y), lattice);
        lattice.period_x *= 2;
        lattice.period_y *= 2;
        ++lattice.seed;
        strength *= 0.5f;
    }
    return sum;
}

} // namespace lambent::kitchen
