// FLIP written down from the papers a second time: in double, with two-dimensional kernels, nothing shared.
#pragma once

#include "image/image.h"

#include <vector>

namespace lambent::compare::testing {

/// One value per pixel, rows from the top; the pictures are linear, [0, 1].
std::vector<double> naive_flip(const image::RadianceImage& test, const image::RadianceImage& reference,
                               double pixels_per_degree);

} // namespace lambent::compare::testing
