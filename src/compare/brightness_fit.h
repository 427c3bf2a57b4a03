// The part of an error that one factor on brightness explains.
#pragma once

#include "compare/difference.h"

namespace lambent::compare {

struct BrightnessFit {
    double factor = 1.0; ///< on the picture, that brings it nearest to the reference
    double error = 0.0;  ///< RMSE over the reference's mean, without the factor
    double left = 0.0;   ///< the same with the factor
};

/// Fits over the pixels that surfaces cover wholly in `picture` (RGBA). All members are 0 without such pixels or light.
/// Throws std::invalid_argument for images of different size.
BrightnessFit brightness_fit(const Pair& pair);

} // namespace lambent::compare
