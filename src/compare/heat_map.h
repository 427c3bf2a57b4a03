// A map of errors as an image with a legend.
#pragma once

#include "compare/error_map.h"
#include "image/image.h"

#include <string>

namespace lambent::compare {

struct HeatLegend {
    std::string title; ///< what is shown
    double top = 1.0;  ///< the value of the lightest colour, above 0
    double mean = 0.0; ///< written beside the title
};

/// 8-bit RGB: the map, pixel by pixel, and below it a bar of all colours with their values. As wide as the map, or as
/// the legend where that is wider.
image::CodeImage heat_map(const ErrorMap& map, const HeatLegend& legend);

/// The smallest of 1, 2, 5 times a power of ten that is not below the largest value; 1 where all are 0.
double round_top(const ErrorMap& map);

} // namespace lambent::compare
