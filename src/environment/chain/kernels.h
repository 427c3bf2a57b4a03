// The loops over texels that run on SIMD lanes, one row a call. Each picks the best instructions of the processor.
#pragma once

#include "environment/chain/cube_chain.h"
#include "environment/chain/gaussian_taps.h"
#include "environment/panorama/panorama.h"

#include <array>
#include <cstdint>
#include <span>

namespace lambent::environment {

/// A place within a texel, from 0 to 1 across and down.
struct TexelPoint {
    float x, y;
};

/// Texels [first, end) of a row of level 0 of a cube: the mean over solid angle of bilinear lookups at these points, as halfs over
/// `chain.scale`. Texels of the panorama above `limit` radiance are dimmed to it.
struct ResampleRow {
    const Panorama* panorama;
    float limit;
    const std::vector<TexelPoint>* points;
    int face;
    int y;
    int first, end;
};
void resample_row(const ResampleRow& row, CubeChain& chain);

/// A row of level `level` of the chain: the taps' mean of the level before.
struct BlurRow {
    const GaussianTaps* taps;
    int level;
    int face;
    int y;
};
void blur_row(const BlurRow& row, CubeChain& chain);

} // namespace lambent::environment
