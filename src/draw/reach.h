// How far rays of sight go, and where they go on.
#pragma once

#include "draw/settings.h"

namespace lambent::draw {

/// Whether the rays of pictures of any size that is drawn stay within Visibility::furthest; elsewhere nothing is seen.
bool within_reach(const RayMap& map);

/// Where a ray that ended at `distance` goes on: a little further, so that it does not meet the same triangle again.
inline float behind(float distance)
{
    return distance * (1.0f + 1e-5f) + 1e-30f;
}

} // namespace lambent::draw
