// The exposures and the tone curve of HDR-FLIP.
//
// Andersson, Nilsson, Shirley, Akenine-Moller 2021, "Visualizing Errors in Rendered High Dynamic Range Images",
// Eurographics short papers, section 3.
#pragma once

#include "image/image.h"

namespace lambent::compare {

/// Linear light of an sRGB code, clamped to [0, 1].
float decoded(float code);

/// The tone curve of HDR-FLIP: ACES as fitted by Krzysztof Narkowicz (2016), x in 0.6 of his units, clamped to [0, 1].
/// Increasing; 0 for negative light.
float tone_mapped(float light);

/// Exposures from `start` to `stop`, in stops, `count` of them at equal steps.
struct Exposures {
    double start = 0.0;
    double stop = 0.0;
    int count = 1;

    double at(int i) const { return count > 1 ? start + (stop - start) * i / (count - 1) : start; }
};

/// Most exposures compared: a ratio of 2^32 between the brightest pixel and the median is more than any image needs,
/// but files may hold any values.
inline constexpr int most_exposures = 32;

/// From the exposure that shows the reference's brightest luminance at 0.85 to the one that shows its median there; one
/// for each stop or part of one, at least two. For images of which half or more is black, the median is that of the
/// other pixels; wholly black ones have the single exposure 0.
Exposures exposures_for(const image::RadianceImage& reference);

/// Exposures for a range in stops: one for each stop begun, at least two, or one if there is no range.
int exposure_count(double start, double stop);

} // namespace lambent::compare
