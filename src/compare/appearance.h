// Statistics of how one image looks.
#pragma once

#include "image/image.h"

namespace lambent::compare {

/// Mean luminance that an sRGB display shows of 8-bit codes, 0 to 1. [IEC 61966-2-1; Rec. 709 weights]
double displayed_luminance(const image::CodeImage& codes);

/// Mean saturation (max - min) / max of 8-bit codes, 0 to 1, over the pixels that a surface covers wholly in `light`
/// (RGBA); black counts as 0. [Smith 1978, HSV]
double mean_saturation(const image::CodeImage& codes, const image::RadianceImage& light);

/// Statistics over all pixels of an image of 8-bit codes.
struct Look {
    double mean;       ///< of the codes, 0 to 1
    double saturation; ///< (max - min) / max, 0 to 1; black counts as 0
    double blank;      ///< share of pixels whose channels are all at least 250
    double black;      ///< share of pixels whose channels are all at most 25
};
Look look_of(const image::CodeImage& codes);

/// RMS difference of the 8-bit codes of two images of one size, divided by 255.
double code_difference(const image::CodeImage& a, const image::CodeImage& b);

/// The share, among the brightest tenth of all pixels, of those in which no two channels have changed their order
/// between light and codes. Channels that became equal have not.
double kept_hue_order(const image::CodeImage& codes, const image::RadianceImage& light);

/// Standard deviation over mean of the luminance of all wholly covered pixels of an RGBA image; 0 without light.
double luminance_spread(const image::RadianceImage& light);

/// Structure of a few pixels that only one of an image and its limit has: the difference less its mean over the 17 x 17
/// pixels around, RMS over the wholly covered pixels of `limit` (RGBA), divided by the mean of the limit there. Both
/// have one size. A smooth shift in brightness does not count; blocks and blur do.
double fine_difference(const image::RadianceImage& picture, const image::RadianceImage& limit);

} // namespace lambent::compare
