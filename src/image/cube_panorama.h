// A cube map unrolled.
#pragma once

#include "image/cube_map.h"

namespace lambent::image {

/// A level as an equirectangular picture, 2 height x height (1 to 32768): rows from +Y down, the middle column is +X, +Z a
/// quarter to its right. Bilinear, across edges too. Throws Error(usage) for other heights.
RadianceImage equirectangular_image(const CubeMap& map, int level, int height);

} // namespace lambent::image
