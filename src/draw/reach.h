// The limits of camera rays, and where they continue behind a surface.
#pragma once

#include "draw/settings.h"

namespace lambent::draw {

/// Whether the camera rays of a picture of any allowed size stay within Visibility::furthest. If not, they hit nothing.
bool within_reach(const RayMap& map);

/// Where a ray continues after a hit at `distance`: slightly further, so that it does not hit the same triangle again.
inline float behind(float distance)
{
    return distance * (1.0f + 1e-5f) + 1e-30f;
}

} // namespace lambent::draw
