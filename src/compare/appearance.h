// Numbers about how one picture looks.
#pragma once

#include "image/image.h"

namespace lambent::compare {

/// Mean luminance that an sRGB display shows of 8-bit codes, 0 to 1. [IEC 61966-2-1; Rec. 709 weights]
double displayed_luminance(const image::CodeImage& codes);

/// Mean saturation (max - min) / max of 8-bit codes, 0 to 1, over the pixels that a surface covers wholly in `light`
/// (RGBA); black counts as 0. [Smith 1978, HSV]
double mean_saturation(const image::CodeImage& codes, const image::RadianceImage& light);

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
