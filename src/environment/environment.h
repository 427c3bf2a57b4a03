// An environment prepared for drawing: the panorama, its blurs, its lamps and its irradiance.
#pragma once

#include "base/identity.h"
#include "environment/chain/cube_chain.h"
#include "environment/bake/irradiance.h"
#include "environment/chain/lamps.h"
#include "environment/panorama/panorama.h"

#include <vector>

namespace lambent::environment {

struct Environment {
    Panorama panorama;        ///< as given: background
    CubeChain chain;          ///< Gaussian blurs: specular light
    Lamps lamps;              ///< bright spots that the chain's coarse levels leave out
    IrradianceMap irradiance; ///< diffuse light
    Identity identity{};      ///< key for data derived from the other members, which then must not change
};

/// Prepares a panorama for drawing, on the threads of the calling TBB arena.
Environment make_environment(Panorama panorama);

/// The report's mip chain: the panorama and its halvings, each exactly half as large, down to a height of 1. A panorama
/// whose sides are not powers of two is first enlarged to such, keeping its light.
std::vector<Panorama> mip_chain(const Panorama& panorama);

} // namespace lambent::environment
