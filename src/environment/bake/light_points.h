// The loop of texel_sums.cpp over points of light, on SIMD lanes.
#pragma once

#include "environment/bake/texel_sums.h"

#include <cstddef>
#include <vector>

namespace lambent::environment {

/// Points of light, for the loop of sum_texels: the arrays may be read 8 beyond the last.
struct LightPoints {
    std::vector<double> x, y, z; ///< direction, about of unit length
    std::vector<double> r, g, b; ///< radiance times solid angle

    void resize(std::size_t count);
};

/// Adds the points [begin, end).
struct LightRange {
    std::size_t begin, end;
};
void add_points(const LightPoints& points, LightRange range, TexelSum& sum);

} // namespace lambent::environment
