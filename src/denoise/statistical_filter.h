// A filter for path-traced pictures that averages only pixels whose light does not differ by a statistical test;
// docs/FILTER.md says how it works.
#pragma once

#include "denoise/light_filter.h"

namespace lambent::denoise {

/// A noisy picture, means over the samples of each pixel; all planes of width x height values.
struct NoisyPicture {
    int width = 0, height = 0;
    Rgb light; ///< linear radiance
    Rgb variance; ///< of the reflected light, for its albedo; unbiased, at least 0; not read where `freedom` is 0
    Plane freedom; ///< degrees of freedom of the variance; 0: it is not known, as of one sample
    Rgb emitted;   ///< part of the light that is not reflected and has no noise of its own: stays as it is
    Rgb albedo; ///< what the rest is proportional to, at least 0. Where all three are 0 the light stays as it is
    Plane coverage;              ///< share of the samples that met what reflects, in (0, 1]
    std::array<Plane, 3> normal; ///< mean over the covered part of the pixel; 0 where nothing is covered
    Plane depth; ///< metres along the ray, mean over the covered part; 0 where nothing is covered
};

/// The filtered light, linear radiance. Any input gives finite output: pixels with values that are not finite, or far
/// beyond those of light, take no part, and come out as they are or, if not finite, as 0. The same bytes with any number
/// of threads. Throws Error(usage) for planes that are not of width x height values.
///
/// Reflected light over albedo is averaged over the pixels less than 8 away, with weights that are products: of surfaces
/// (normal, depth), 0 across their edges; of Welch's test of the two pixels' means, 0 or 1; of the same test's mean over
/// the 3 x 3 pixels around both; of distance, albedo and the fourth root of the inverse variance. The more samples, the
/// fewer pixels pass as equal, so the result converges to the truth as `light` does. [Sakai et al. 2024, "A statistical
/// approach to Monte Carlo denoising"; patches: Buades, Coll and Morel 2005, "A non-local algorithm for image denoising"]
/// Variances have few degrees of freedom, and that of a pixel whose samples all missed the light is 0: each is pooled with
/// its neighbours', as a prior of 4 degrees of freedom. [moderated t: Smyth 2004, "Linear models and empirical Bayes
/// methods"] Where the average is further from the unfiltered light than noise explains, it gives way to that.
/// [shrinkage: James and Stein 1961]
Rgb filter_statistically(const NoisyPicture& picture);

} // namespace lambent::denoise
