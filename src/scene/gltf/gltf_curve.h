// Numbers that change with time: the keys of a glTF animation sampler and what lies between them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent::scene {

/// How values go from key to key. [glTF 2.0, 3.11 and appendix C]
enum class Interpolation : std::uint8_t { step, linear, cubic };

struct Curve {
    std::vector<float> times;  ///< of the keys, seconds, never descending; at least one
    std::vector<float> values; ///< `width` for each key; cubic: its in-tangent, itself and its out-tangent
    std::size_t width = 1;     ///< at least 1
    Interpolation interpolation = Interpolation::linear;
    bool rotation = false; ///< quaternions x, y, z, w, none of length zero
};

/// `width` numbers: the value at a time, which before the first key is the first one's and after the last the
/// last one's. Rotations go along the shorter arc and are of unit length.
std::vector<double> value_at(const Curve& curve, double seconds);

} // namespace lambent::scene
