// A cube map unrolled.
#pragma once

#include "image/cube/cube_map.h"

namespace lambent::image {

/// A level as an equirectangular picture, 2 height x height (1 to 32768): rows from +Y down, the middle column
/// is +X, +Z a quarter to its right. Bilinear, across the edges of faces too.
/// Throws Error(usage) for another height, for a level that is not there, and as check_cube_map.
RadianceImage equirectangular_image(const CubeMap& map, int level, int height);

} // namespace lambent::image
