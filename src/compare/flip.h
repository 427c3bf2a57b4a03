// FLIP: how much of a difference people see who flip between two pictures.
#pragma once

#include "compare/plane.h"
#include "image/image.h"

namespace lambent::compare {

/// 0.7 m from a 3840 pixels wide screen of 0.7 m: what the paper's figures are made for.
constexpr double usual_pixels_per_degree = 67.0;

/// Perceived difference of each pixel, 0 to 1, of two pictures in linear sRGB colour as displayed, [0, 1].
/// [Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating Images", HPG]
Plane flip(const image::RadianceImage& picture, const image::RadianceImage& reference,
           double pixels_per_degree = usual_pixels_per_degree);

/// Exposures in stops, factors 2^e on the light.
struct Exposures {
    double start = 0.0, stop = 0.0;
    int count = 0;
};

/// Those at which the reference's brightest and its median luminance are shown at 0.85, and whole stops between.
/// [Andersson et al. 2021, section 3.2]
Exposures exposures_for(const image::RadianceImage& reference);

/// HDR-FLIP of linear light: the largest FLIP over the exposures, each shown through a filmic tone curve.
/// [Andersson et al. 2021, "Visualizing Errors in Rendered High Dynamic Range Images", Eurographics short papers]
Plane hdr_flip(const image::RadianceImage& picture, const image::RadianceImage& reference,
               double pixels_per_degree = usual_pixels_per_degree);

/// Mean of all values.
double mean(const Plane& plane);

} // namespace lambent::compare
