// FLIP's feature pipeline: edges and points that one picture has and the other has not.
#pragma once

#include "compare/plane.h"

namespace lambent::compare {

/// Difference in edges or points, whichever is larger, of each pixel, 0 to 1. Planes are the Yy channel, -16 to 100.
/// [Andersson et al. 2020, section 4.2]
Plane feature_difference(const Plane& picture, const Plane& reference, double pixels_per_degree);

} // namespace lambent::compare
