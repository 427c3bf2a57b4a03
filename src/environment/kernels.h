// The loops over texels that run on SIMD lanes, one row a call. Each picks the best instructions of the processor.
#pragma once

#include "environment/cube_chain.h"
#include "environment/panorama.h"

#include <array>
#include <cstdint>
#include <span>

namespace lambent::environment {

/// Packs `count` RGB texels, multiplied by `factor`. Values must be finite and not negative.
void pack_row(const float* rgb, int count, float factor, std::uint32_t* texels);

/// Per column of a panorama: cosines and sines of the azimuth and of twice that.
struct AzimuthOrders {
    static constexpr std::size_t padding = 16; ///< more floats than columns: whole vectors are read
    std::vector<float> rows[4];                ///< cos, sin, cos 2, sin 2
};

/// A row's radiance times 1 and times each of these, summed: [channel][order].
std::array<std::array<double, 5>, 3> row_moments(const Panorama& panorama, int y,
                                                 const AzimuthOrders& orders);

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

/// Directions around +z in which a Gaussian on the sphere is sampled, all of equal weight.
struct GaussianTaps {
    static constexpr int around = 8; ///< of a ring
    std::vector<float> x, y, z;
};

/// Taps of standard deviation `deviation` radians on 4 or 5 rings, each turned by half a step against the one before. Their
/// mean is +z and their moments up to the seventh are alike in all directions, so that a blur moves no light and looks the
/// same in the frames of neighbouring faces.
GaussianTaps gaussian_taps(int rings, float deviation);

/// A row of level `level` of the chain: the taps' mean of the level before.
struct BlurRow {
    const GaussianTaps* taps;
    int level;
    int face;
    int y;
};
void blur_row(const BlurRow& row, CubeChain& chain);

/// Irradiance at the texels of one row of a one-level chain: the sum over cells of max(N . moment, 0), each cell being
/// its light times direction, in three arrays of (r, g, b).
struct LightCells {
    std::vector<float> x[3], y[3], z[3]; ///< [channel]
};
void irradiance_row(const LightCells& cells, int face, int y, CubeChain& map);

} // namespace lambent::environment
