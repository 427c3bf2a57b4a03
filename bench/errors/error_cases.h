// A picture of each scene under each environment, drawn and traced.
#pragma once

#include "bench/errors/region_error.h"

#include <string>
#include <vector>

namespace lambent::bench {

struct ErrorCase {
    std::string scene;       ///< built-in, or a file
    std::string environment; ///< built-in, or a file
    std::string model;       ///< "ggx" or "phong"
};

struct CaseErrors {
    RegionError clamped_40, clamped_1024; ///< against light without shadows, both cut to [0, 1]
    RegionError whole_40, whole_1024;     ///< the same without the cut
    RegionError full_40;                  ///< against light with shadows and eight bounces, cut to [0, 1]
};

/// Draws with 40 and 1024 samples and traces the two references, each for `seconds`, at width x (9/16 width).
CaseErrors measure(const ErrorCase& c, int width, double seconds);

} // namespace lambent::bench
