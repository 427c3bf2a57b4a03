// FLIP once more, from the papers' formulas as they stand: in double, with whole squares of weights, one pixel at a
// time. Shares nothing with src/compare.
#pragma once

#include "image/image.h"

#include <vector>

namespace lambent::compare::test {

/// A square of weights, (2 radius + 1)^2, rows first.
struct Square {
    int radius = 0;
    std::vector<double> weights;

    double at(int dx, int dy) const
    {
        return weights[static_cast<std::size_t>((dy + radius) * (2 * radius + 1) + dx + radius)];
    }
};

enum class Channel { achromatic, red_green, blue_yellow };

Square naive_contrast_filter(Channel channel, double pixels_per_degree);

/// Along x; `point` is the second derivative, else the first.
Square naive_feature_filter(bool point, double pixels_per_degree);

/// Values of every pixel of pictures of sRGB codes.
std::vector<double> naive_ldr_flip(const image::RadianceImage& picture, const image::RadianceImage& reference,
                                   double pixels_per_degree);

/// The same for light.
std::vector<double> naive_hdr_flip(const image::RadianceImage& picture, const image::RadianceImage& reference,
                                   double pixels_per_degree);

} // namespace lambent::compare::test
