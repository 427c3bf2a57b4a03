// Rays of sight as a projection, for rasterising what they see.
#pragma once

#include "draw/settings.h"
#include "gpu_layout/layout.h"
#include "scene/scene.h"

#include <glm/vec2.hpp>

#include <optional>

namespace lambent::draw {

struct RasterWindow {
    int x = 0, y = 0, width = 1, height = 1; ///< pixels of the picture
    glm::vec2 place{0.5f};                   ///< that is looked at in every pixel
};

/// Clip coordinates by the world's, relative to the origin of the rays: the place of a window's pixel (i, j) in the middle
/// of that of the target, depth 1 near and 0 far. None where the rays fill no volume; `bounds`: of all that is seen.
std::optional<gpu_layout::RasterConstants> raster_map(const RayMap& rays, const RasterWindow& window,
                                                      const scene::Bounds& bounds);

} // namespace lambent::draw
