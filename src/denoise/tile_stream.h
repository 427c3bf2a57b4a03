// One tile of one class of light, filtered as a stream of rows.
#pragma once

#include "denoise/control_shares.h"
#include "denoise/light_filter.h"

namespace lambent::denoise {

/// One class of light to be filtered.
struct LightJob {
    const Picture& picture;
    const Light& light;
    const ControlShares& shares;
    bool lobe; ///< specular: pixels are alike only if their lobes point the same way
    const Settings& settings;
    const TakeRow& take; ///< gets the rows of the result
};

/// Pixels from (x0, y0) to before (x1, y1).
struct Tile {
    int x0, y0, x1, y1;
};

/// Filters a tile; nothing outside of it is written. How a picture is cut into tiles does not change a bit of it.
void filter_tile(const LightJob& job, const Tile& tile);

} // namespace lambent::denoise
