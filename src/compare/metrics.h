// How far a picture is off another, as numbers.
#pragma once

#include "image/image.h"

#include <cstdint>

namespace lambent::compare {

/// Over all pixels and the three colour channels; alpha is not looked at.
struct Metrics {
    double rmse = 0.0;          ///< sqrt(mean((a - b)^2))
    double relative_rmse = 0.0; ///< rmse / mean(b); infinite if b is black and a is not, 0 if both are
    double psnr = 0.0;          ///< dB: 20 log10(peak / rmse); infinite for equal pictures
    double max = 0.0;           ///< largest |a - b|
};

/// The picture against the reference, of the same size, all values finite. `peak` of the PSNR: 1 for codes; for light the
/// largest value of the reference.
Metrics measure(const image::RadianceImage& picture, const image::RadianceImage& reference, double peak);

/// The largest value of the three channels, at least 0.
float largest_value(const image::RadianceImage& image);

/// Values above `limit` become it, those below 0 become 0.
void clamp_values(image::RadianceImage& image, float limit);

/// Values that are no number or infinite become 0; returns how many.
std::uint64_t mend_values(image::RadianceImage& image);

} // namespace lambent::compare
