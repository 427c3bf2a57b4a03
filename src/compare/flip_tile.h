// FLIP over a rectangle of the images small enough for the processor's caches.
#pragma once

#include "compare/difference.h"
#include "compare/flip_filters.h"

namespace lambent::compare {

/// How a pixel becomes the light of a display, linear and in [0, 1].
struct Shown {
    bool codes = true;   ///< sRGB codes in [0, 1]; else light, through the tone curve of flip_exposures.h
    float factor = 1.0f; ///< on light, before the curve
};

struct Tile {
    int left, top, width, height;
};

/// Sizes that keep the filtered planes in the cache, and the borders, which are computed twice, small.
inline constexpr int tile_width = 256, tile_height = 128;

/// Sets the tile's pixels of `map`, which has the images' size, to the larger of their value and the LDR-FLIP error.
/// Pixels beyond the images' borders are those of the border.
void flip_tile(const Pair& pair, const FlipFilters& filters, const Shown& shown, const Tile& tile,
               ErrorMap& map);

} // namespace lambent::compare
