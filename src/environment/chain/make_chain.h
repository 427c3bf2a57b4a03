// From a panorama to the cube of its blurs.
#pragma once

#include "environment/chain/cube_chain.h"
#include "environment/chain/lamps.h"
#include "environment/panorama/panorama.h"

namespace lambent::environment {

/// The chain of blurs, and the lamps that are not in all its levels.
struct Blurs {
    CubeChain chain;
    Lamps lamps;
};

/// [see equations/footprint.glsl for why Gaussians]
Blurs make_blurs(const Panorama& panorama);

/// The panorama on a cube of faces of 2^log2_size texels, one level, as sharp as they are.
CubeChain resampled(const Panorama& panorama, int log2_size);

/// The chain alone, every lamp in every level.
CubeChain make_chain(const Panorama& panorama);

} // namespace lambent::environment
