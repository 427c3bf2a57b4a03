// Measures the error of a baked cube's levels: some texels against the sum over the whole panorama, in double.
#pragma once

#include "environment/chain/cube_faces.h"
#include "environment/panorama/panorama.h"
#include "environment/bake/prefilter.h"
#include "image/cube/cube_map.h"

#include <vector>

namespace lambent::environment {

struct CheckedLevel {
    int level;
    PrefilterLobe lobe;
};

/// How a panorama's texels are interpreted: as points of light, or as knots of linear interpolation.
enum class TexelMeaning { points, knots };

/// The relative RMSE of each given level: the larger of that at random texels and that at random texels near its
/// brightest.
std::vector<double> check_levels(const Panorama& panorama, TexelMeaning meaning, const image::CubeMap& cube,
                                 const std::vector<CheckedLevel>& levels);

/// A texel of a face of `size` texels a side, and the direction of its centre.
struct CubeTexel {
    int face, x, y, size;
};
Direction texel_direction(const CubeTexel& texel);

} // namespace lambent::environment
