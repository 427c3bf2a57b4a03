// FLIP: how different two images look to a viewer who alternates between them.
//
// LDR-FLIP: Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating Images", HPG.
// HDR-FLIP: Andersson et al. 2021, "Visualizing Errors in Rendered High Dynamic Range Images", Eurographics.
#pragma once

#include "compare/difference.h"
#include "compare/error_map.h"
#include "compare/flip_exposures.h"
#include "compare/flip_filters.h"

#include <functional>

namespace lambent::compare {

/// Called with the share that is done, from 0 to 1, by one thread at a time.
using Progress = std::function<void(float)>;

struct FlipSettings {
    double pixels_per_degree = usual_pixels_per_degree;
    Progress progress; ///< may be empty
};

/// Errors from 0 (no visible difference) to 1, between images of sRGB codes in [0, 1]. Symmetric.
/// Throws std::invalid_argument for images of different size.
ErrorMap ldr_flip(const Pair& pair, const FlipSettings& settings = {});

struct HdrFlip {
    ErrorMap map;
    Exposures exposures;
};

/// The same for linear light: the largest LDR-FLIP error at any exposure of exposures_for() the reference. Not
/// symmetric; unchanged if both images are multiplied by one factor.
HdrFlip hdr_flip(const Pair& pair, const FlipSettings& settings = {});

} // namespace lambent::compare
