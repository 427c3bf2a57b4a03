// Converts cube maps to equirectangular images.
#pragma once

#include "image/cube/cube_map.h"

namespace lambent::image {

/// A level as an equirectangular image of 2 height x height texels: rows from +Y down, +X in the middle column, +Z
/// a quarter of the width to its right. Lookups are bilinear, also across the edges of faces.
/// Throws Error(usage) unless the height is 1 to 32768 and the level exists, and as check_cube_map.
RadianceImage equirectangular_image(const CubeMap& map, int level, int height);

} // namespace lambent::image
