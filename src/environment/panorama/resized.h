// A panorama at another size, light kept.
#pragma once

#include "environment/panorama/panorama.h"

namespace lambent::environment {

/// The picture at another size: each texel the mean over its solid angle of the picture read linearly between its
/// columns and image::row_angles(), across the poles too. The light of every texel, radiance times solid angle, is kept.
Panorama resized(const Panorama& from, int width, int height);

/// Enlarged to that size if it is smaller: a sum over texels takes each for a point.
Panorama at_least(const Panorama& panorama, int width, int height);

} // namespace lambent::environment
