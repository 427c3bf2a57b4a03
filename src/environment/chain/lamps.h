// The brightest spots of an environment as lamps without size: a sample that stands for a wide part of a lobe reads a
// blur, and a small lamp is smeared over all of that; the lobe itself is known where the lamp is.
#pragma once

#include "environment/chain/cube_chain.h"
#include "environment/chain/peaks.h"

#include <vector>

namespace lambent::environment {

/// A spot as seen from infinitely far away.
struct Lamp {
    float direction[3]; ///< unit length, to its middle
    float light[3];     ///< radiance times solid angle, RGB
    float variance;     ///< angular, about its middle, per axis, square radians
};

struct Lamps {
    std::vector<Lamp> lamps; ///< few: each costs about a quarter of a sample
    int last_level = 0;      ///< of the chain that holds their light; from the next on it has to be added
};

/// The peaks, merged to at most 16 lamps, at the finest level whose blur hides that they are merged.
Lamps choose_lamps(const Peaks& peaks, const CubeChain& chain);

/// Blur of a level, as its angular variance in square radians.
float level_variance(const CubeChain& chain, int level);

} // namespace lambent::environment
