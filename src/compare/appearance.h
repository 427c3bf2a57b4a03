// Numbers about how one picture looks.
#pragma once

#include "image/image.h"

namespace lambent::compare {

/// Mean luminance that an sRGB display shows of 8-bit codes, 0 to 1. [IEC 61966-2-1; Rec. 709 weights]
double displayed_luminance(const image::CodeImage& codes);

/// Mean saturation (max - min) / max of 8-bit codes, 0 to 1, over the pixels that a surface covers wholly in `light`
/// (RGBA); black counts as 0. [Smith 1978, HSV]
double mean_saturation(const image::CodeImage& codes, const image::RadianceImage& light);

/// How a picture of 8-bit codes looks, over all of its pixels.
struct Look {
    double mean;       ///< of the codes, 0 to 1
    double saturation; ///< (max - min) / max, 0 to 1; black counts as 0
    double blank;      ///< share of pixels whose channels are all at least 250
    double black;      ///< share of pixels whose channels are all at most 25
};
Look look_of(const image::CodeImage& codes);

/// RMS difference of the 8-bit codes of two pictures of one size, in parts of 255.
double code_difference(const image::CodeImage& a, const image::CodeImage& b);

/// Of the tenth of all pixels with the most light: the share in which no two channels have changed their order between
/// light and codes. Two that became equal have not.
double kept_hue_order(const image::CodeImage& codes, const image::RadianceImage& light);

/// Standard deviation over mean of the luminance of all wholly covered pixels of an RGBA picture; 0 without light.
double luminance_spread(const image::RadianceImage& light);

/// Structure of a few pixels that a picture has and its limit does not, or the other way about: the difference less its
/// mean over the 17 x 17 pixels around, RMS over the wholly covered pixels of `limit` (RGBA), divided by the mean of
/// the limit there. Both of one size. A shift in brightness counts as nothing; blocks and blur do not hide.
double fine_difference(const image::RadianceImage& picture, const image::RadianceImage& limit);

} // namespace lambent::compare
