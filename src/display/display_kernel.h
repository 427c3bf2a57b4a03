// The pixels of one row, on SIMD lanes.
#pragma once

#include "display/display.h"

#include <cstdint>

namespace lambent::display {

/// `count` pixels of `channels` (3 or 4) floats to 3 codes each. y is the row, for the dither pattern.
struct DisplayRow {
    const float* light;
    int channels;
    int count;
    int y;
    const float* unlit = nullptr; ///< RGBA of each pixel, as RadianceImage::unlit; null: none
};
void display_row(const DisplayRow& row, const Settings& settings, std::uint8_t* codes);

} // namespace lambent::display
