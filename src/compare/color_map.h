// Numbers as colours.
#pragma once

#include <array>
#include <cstdint>

namespace lambent::compare {

/// sRGB codes.
using Code = std::array<std::uint8_t, 3>;

/// The colour for an error in [0, 1] (others are cut, NaN is 0): from black over violet, red and orange to a light
/// yellow. Lightness L* grows evenly from 0 to 96, so that the order stays to be seen in grey and for the colour-blind.
Code color_of(float error);

} // namespace lambent::compare
