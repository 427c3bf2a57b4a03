// The loops of irradiance.cpp over texels and cells, on SIMD lanes, one row per call.
#pragma once

#include "environment/chain/cube_chain.h"
#include "environment/panorama/panorama.h"

#include <array>
#include <cstddef>
#include <vector>

namespace lambent::environment {

/// Per column of a panorama: cosines and sines of the azimuth and of twice that.
struct AzimuthOrders {
    static constexpr std::size_t padding = 16; ///< floats beyond the last column, as whole vectors are read
    std::vector<float> rows[4];                ///< cos, sin, cos 2, sin 2
};

/// Sums along a row of radiance times 1 and times each of `orders`: [channel][order].
std::array<std::array<double, 5>, 3> row_moments(const Panorama& panorama, int y,
                                                 const AzimuthOrders& orders);

/// Irradiance at the texels of one row of a one-level chain: the sum over cells of max(N . moment, 0), each cell being
/// its light times direction, in three arrays of (r, g, b).
struct LightCells {
    std::vector<float> x[3], y[3], z[3]; ///< [channel]
};
void irradiance_row(const LightCells& cells, int face, int y, CubeChain& map);

} // namespace lambent::environment
