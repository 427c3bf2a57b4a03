// How far a picture is off a noisy reference, region by region.
#pragma once

#include "image/image.h"

#include <vector>

namespace lambent::bench {

/// A label for each pixel, row by row; below 0: belongs to none.
using Regions = std::vector<int>;

struct RegionError {
    double mean = 0.0;    ///< over the regions: relative RMSE, sqrt(mean((a - b)^2)) / mean(b)
    double largest = 0.0; ///< of them
    double most =
        0.0; ///< upper end of the interval of `mean`, two standard errors of the noise wide on either side
    bool resolved = true; ///< whether the lower end is above 0
};

/// Two references of the same picture whose noise is independent.
struct ReferencePair {
    const image::RadianceImage *first, *second;
};

/// Squared differences are taken as (a - first)(a - second): its mean is the square of the true difference, whatever
/// the noise. All pictures are cut to [0, limit] first; close to the limit that moves a noisy value a little.
RegionError region_error(const image::RadianceImage& picture, const ReferencePair& reference,
                         const Regions& regions, float limit);

} // namespace lambent::bench
