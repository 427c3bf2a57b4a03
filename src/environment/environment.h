// An environment ready to draw with: what light comes from where, at every sharpness.
#pragma once

#include "base/identity.h"
#include "environment/chain/cube_chain.h"
#include "environment/bake/irradiance.h"
#include "environment/chain/lamps.h"
#include "environment/panorama/panorama.h"

#include <vector>

namespace lambent::environment {

struct Environment {
    Panorama panorama;        ///< the picture itself: background
    CubeChain chain;          ///< Gaussian blurs: specular light
    Lamps lamps;              ///< what the coarse ones of them do without
    IrradianceMap irradiance; ///< diffuse light
    Identity identity{};      ///< for who keeps something made from the others, which then must not change
};

/// Everything from the panorama. `threads` are those of the calling TBB arena.
Environment make_environment(Panorama panorama);

/// The panorama and its halvings, exactly 2^k times smaller, down to a height of 1: the report's own mip chain.
/// The panorama is first enlarged to powers of two, its light kept, if it is not.
std::vector<Panorama> mip_chain(const Panorama& panorama);

} // namespace lambent::environment
