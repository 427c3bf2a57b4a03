// The loop of texel_sums.cpp over points of light, on SIMD lanes.
#pragma once

#include "environment/bake/texel_sums.h"

#include <cstddef>
#include <vector>

namespace lambent::environment {

/// Points of light, for the loop of sum_texels. The arrays have 8 values more than points, as whole vectors are read.
struct LightPoints {
    std::vector<double> x, y, z; ///< direction, of about unit length
    std::vector<double> r, g, b; ///< radiance times solid angle

    void resize(std::size_t count);
};

/// Adds the light of points [begin, end), weighted by the sum's lobe.
struct LightRange {
    std::size_t begin, end;
};
void add_points(const LightPoints& points, LightRange range, TexelSum& sum);

} // namespace lambent::environment
