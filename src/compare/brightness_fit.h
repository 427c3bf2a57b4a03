// How much of an error is brightness alone.
#pragma once

#include "compare/difference.h"

namespace lambent::compare {

struct BrightnessFit {
    double factor = 1.0; ///< on the picture, that brings it nearest to the reference
    double error = 0.0;  ///< RMSE over the reference's mean, without it
    double left = 0.0;   ///< the same with it
};

/// Over the pixels that surfaces cover wholly in `picture` (RGBA). All 0 without any, or without light.
/// Throws std::invalid_argument for pictures of different size.
BrightnessFit brightness_fit(const Pair& pair);

} // namespace lambent::compare
