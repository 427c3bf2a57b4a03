// A map from errors to colours.
#pragma once

#include <array>
#include <cstdint>

namespace lambent::compare {

/// sRGB codes.
using Code = std::array<std::uint8_t, 3>;

/// The colour for an error, clamped to [0, 1], NaN as 0: from black over violet, red and orange to a light yellow.
/// Lightness L* grows evenly from 0 to 96, so that the order is visible in grey and to colour-blind viewers.
Code color_of(float error);

} // namespace lambent::compare
