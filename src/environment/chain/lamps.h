// The brightest spots of an environment as lights without size. A sample that represents a wide part of a lobe reads a
// blur, which would smear a small lamp over that part; evaluating the lobe in the lamp's direction is exact.
#pragma once

#include "environment/chain/cube_chain.h"
#include "environment/chain/peaks.h"

#include <vector>

namespace lambent::environment {

/// A bright spot, infinitely far away.
struct Lamp {
    float direction[3]; ///< unit length, to its centre
    float light[3];     ///< radiance times solid angle, RGB
    float variance;     ///< angular, about its centre, per axis, square radians
};

struct Lamps {
    std::vector<Lamp> lamps; ///< few: each costs about a quarter of a sample
    int last_level = 0;      ///< last level of the chain with their light; to coarser levels it must be added
};

/// Merges the peaks to at most 16 lamps. The chain leaves them out from the finest level on whose blur hides the
/// merging.
Lamps choose_lamps(const Peaks& peaks, const CubeChain& chain);

/// Angular variance of a level's blur, in square radians.
float level_variance(const CubeChain& chain, int level);

} // namespace lambent::environment
