// Functions of time: the keys of a glTF animation sampler, and the interpolation between them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent::scene {

/// Interpolation between keys. [glTF 2.0, 3.11 and appendix C]
enum class Interpolation : std::uint8_t { step, linear, cubic };

struct Curve {
    std::vector<float> times;  ///< of the keys, seconds, never descending; at least one
    std::vector<float> values; ///< `width` numbers per key; cubic: in-tangent, value and out-tangent, each
    std::size_t width = 1;     ///< at least 1
    Interpolation interpolation = Interpolation::linear;
    bool rotation = false; ///< quaternions x, y, z, w, none of length zero
};

/// The value at a time, `width` numbers: the first key's before it and the last key's after it. Rotations follow the
/// shorter arc and have unit length.
std::vector<double> value_at(const Curve& curve, double seconds);

} // namespace lambent::scene
