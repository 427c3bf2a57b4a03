// A hash for random numbers.
#pragma once

#include <cstdint>

namespace lambent {

/// Hash of two 32-bit numbers. [O'Neill 2014, PCG, output function RXS-M-XS]
inline std::uint32_t hashed(std::uint32_t a, std::uint32_t b)
{
    std::uint32_t state = (a ^ (b * 0x9e3779b9u + 0x7f4a7c15u)) * 747796405u + 2891336453u;
    state = ((state >> ((state >> 28) + 4)) ^ state) * 277803737u;
    return (state >> 22) ^ state;
}

} // namespace lambent
