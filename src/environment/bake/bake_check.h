// What a baked cube's levels are worth: some texels against the sum over all of the panorama, in double.
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

/// What a panorama's texels are: points of light, or what it is read linearly between.
enum class TexelMeaning { points, knots };

/// The relative RMSE of each level given, at random texels and at random ones near its brightest: whichever is larger.
std::vector<double> check_levels(const Panorama& panorama, TexelMeaning meaning, const image::CubeMap& cube,
                                 const std::vector<CheckedLevel>& levels);

/// The direction of a texel's middle.
struct CubeTexel {
    int face, x, y, size;
};
Direction texel_direction(const CubeTexel& texel);

} // namespace lambent::environment
