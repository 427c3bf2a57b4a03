// The loops over texels that run on SIMD lanes, one row per call, with the processor's best instructions.
#pragma once

#include "environment/chain/cube_chain.h"
#include "environment/chain/gaussian_taps.h"
#include "environment/panorama/panorama.h"

#include <array>
#include <cstdint>
#include <span>

namespace lambent::environment {

/// A sample position within a texel, from 0 to 1 across and down.
struct TexelPoint {
    float x, y;
};

/// Fills texels [first, end) of a row of level 0 of a cube: each the mean over solid angle of bilinear lookups at
/// `points`, as halfs over `chain.scale`. Texels of the panorama above `limit` radiance are dimmed to it.
struct ResampleRow {
    const Panorama* panorama;
    float limit;
    const std::vector<TexelPoint>* points;
    int face;
    int y;
    int first, end;
};
void resample_row(const ResampleRow& row, CubeChain& chain);

/// Fills a row of level `level` of the chain: each texel the mean, over the taps, of lookups in the level before.
struct BlurRow {
    const GaussianTaps* taps;
    int level;
    int face;
    int y;
};
void blur_row(const BlurRow& row, CubeChain& chain);

} // namespace lambent::environment
