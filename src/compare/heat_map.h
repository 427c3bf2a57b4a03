// A picture of where two pictures differ.
#pragma once

#include "compare/plane.h"
#include "image/image.h"

#include <string>

namespace lambent::compare {

/// The colour of a value from 0 to 1, 8-bit sRGB: from black to white, each step brighter to the eye than the one before.
/// [Green 2011, "A colour scheme for the display of astronomical intensity images": cubehelix]
struct HeatColor {
    std::uint8_t r, g, b;
};
HeatColor heat_color(float value);

/// What the legend says.
struct Legend {
    std::string title; ///< capitals, figures and signs of pixel_font.h
    float most = 1.0f; ///< the value at the end of the colour bar; larger ones get its colour
    double mean = 0.0;
};

/// The values in colour, and below them a bar with its scale, the title and the mean.
image::CodeImage heat_map(const Plane& values, const Legend& legend);

/// |a - b| / (mean of the reference's channels + a hundredth of the picture's mean), the largest of three channels.
Plane relative_difference(const image::RadianceImage& picture, const image::RadianceImage& reference);

/// |a - b|, the largest of three channels.
Plane absolute_difference(const image::RadianceImage& picture, const image::RadianceImage& reference);

} // namespace lambent::compare
