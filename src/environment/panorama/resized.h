// A panorama at another size, keeping its light.
#pragma once

#include "environment/panorama/panorama.h"

namespace lambent::environment {

/// The panorama at another size: each texel is the mean over its solid angle of the panorama interpolated linearly
/// between its columns and image::row_angles(), also across the poles. The light of every texel, radiance times solid
/// angle, is kept.
Panorama resized(const Panorama& from, int width, int height);

/// The panorama, enlarged to that size if it is smaller, for sums over texels, which treat each as a point.
Panorama at_least(const Panorama& panorama, int width, int height);

} // namespace lambent::environment
