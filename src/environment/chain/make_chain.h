// Makes the chain of blurs of a panorama.
#pragma once

#include "environment/chain/cube_chain.h"
#include "environment/chain/lamps.h"
#include "environment/panorama/panorama.h"

namespace lambent::environment {

/// The chain of blurs, and the lamps that its coarse levels leave out.
struct Blurs {
    CubeChain chain;
    Lamps lamps;
};

/// Blurs a panorama level by level; equations/footprint.glsl tells why by Gaussians.
Blurs make_blurs(const Panorama& panorama);

/// The panorama resampled, without blur, to one level of faces of 2^log2_size texels.
CubeChain resampled(const Panorama& panorama, int log2_size);

/// The chain alone, with every lamp in every level.
CubeChain make_chain(const Panorama& panorama);

} // namespace lambent::environment
