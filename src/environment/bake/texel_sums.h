// Means over lobes by sums over all texels, in double, against which the tree of cells is checked.
#pragma once

#include "environment/bake/prefilter.h"
#include "environment/panorama/panorama.h"

#include <span>

namespace lambent::environment {

/// A direction, the lobe about it, and the mean of light over that lobe, which sum_texels() sets.
struct TexelSum {
    double x = 0.0, y = 0.0, z = 0.0; ///< unit length
    PrefilterLobe lobe;
    double rgb[3] = {};
};
void sum_texels(const Panorama& panorama, std::span<TexelSum> sums);

} // namespace lambent::environment
