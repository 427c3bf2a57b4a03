// Means over lobes summed over all texels in double: what the tree of cells is checked by.
#pragma once

#include "environment/bake/prefilter.h"
#include "environment/panorama/panorama.h"

#include <span>

namespace lambent::environment {

/// A direction in which the mean over a lobe is wanted of all texels, one by one, in double: to check the tree by.
struct TexelSum {
    double x = 0.0, y = 0.0, z = 0.0; ///< unit length
    PrefilterLobe lobe;
    double rgb[3] = {};
};
void sum_texels(const Panorama& panorama, std::span<TexelSum> sums);

} // namespace lambent::environment
