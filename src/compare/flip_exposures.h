// How HDR-FLIP makes displayed pictures of light.
//
// Andersson, Nilsson, Shirley, Akenine-Moller 2021, "Visualizing Errors in Rendered High Dynamic Range Images",
// Eurographics short papers, section 3.
#pragma once

#include "image/image.h"

namespace lambent::compare {

/// sRGB codes in [0, 1] (others are cut) to linear light.
float decoded(float code);

/// The ACES curve as fitted by Krzysztof Narkowicz (2016), x in 0.6 of his units, cut to [0, 1]: what HDR-FLIP looks at
/// light through. Rises; negative light is 0.
float tone_mapped(float light);

/// Exposures from `start` to `stop`, in stops, `count` of them at equal steps.
struct Exposures {
    double start = 0.0;
    double stop = 0.0;
    int count = 1;

    double at(int i) const { return count > 1 ? start + (stop - start) * i / (count - 1) : start; }
};

/// Most exposures looked at: 2^32 between the brightest pixel and the median is more than any picture needs, but a file
/// may claim what it likes.
inline constexpr int most_exposures = 32;

/// From the exposure that shows the reference's brightest luminance at 0.85 to the one that shows its median there; one
/// for each stop or part of one, at least two. Pictures that are half black or more have the median of what is not, and
/// black ones the single exposure 0.
Exposures exposures_for(const image::RadianceImage& reference);

/// Exposures for a range in stops: one for each stop begun, at least two, or one if there is no range.
int exposure_count(double start, double stop);

} // namespace lambent::compare
