// One number for each pixel.
#pragma once

#include <vector>

namespace lambent::compare {

struct ErrorMap {
    int width = 0;
    int height = 0;
    std::vector<float> values; ///< width * height, rows from the top
};

/// The mean of all values; 0 without any.
double mean(const ErrorMap& map);

} // namespace lambent::compare
