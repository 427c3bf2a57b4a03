// Camera rays as a projection for the rasteriser.
#pragma once

#include "draw/settings.h"
#include "gpu_layout/layout.h"
#include "scene/scene.h"

#include <glm/vec2.hpp>

#include <optional>

namespace lambent::draw {

struct RasterWindow {
    int x = 0, y = 0, width = 1, height = 1; ///< pixels of the picture
    glm::vec2 place{0.5f};                   ///< of the look in each pixel, [0, 1)
};

/// The matrix from world space, relative to the origin of the rays, to clip space. It projects the look of the
/// window's pixel (i, j) to the centre of the target's pixel (i, j); depth is 1 at the near end and 0 at the far end.
/// Returns nothing where the rays span no volume or the scene lies behind them. `bounds` encloses everything visible.
std::optional<gpu_layout::RasterConstants> raster_map(const RayMap& rays, const RasterWindow& window,
                                                      const scene::Bounds& bounds);

} // namespace lambent::draw
