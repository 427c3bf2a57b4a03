// FLIP over a rectangle of the picture small enough for the processor's caches.
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

/// Sides that keep the filtered planes in the cache and the borders, computed twice, small.
inline constexpr int tile_width = 256, tile_height = 128;

/// Puts the larger of what is there and the LDR-FLIP error into the tile's pixels of `map`, which has the pictures'
/// size. Pixels beyond the pictures' borders are those of the border.
void flip_tile(const Pair& pair, const FlipFilters& filters, const Shown& shown, const Tile& tile,
               ErrorMap& map);

} // namespace lambent::compare
