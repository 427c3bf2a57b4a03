// How far a picture is from the path-traced truth: a measured error, with an interval that holds the true one.
#pragma once

#include "audit/interval.h"
#include "image/image.h"
#include "reference/pixel_tracer.h"

#include <glm/ext/vector_double3.hpp>

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

namespace lambent::audit {

/// The defaults trace 512 x (2 x 128 + 16 x 8) = 197 thousand paths.
struct Settings {
    /// Light above this counts as this, in the picture and in the truth: 1 / exposure for what a display shows. Above 0.
    double cut = std::numeric_limits<double>::infinity();
    int pixels = 512;  ///< pixels that are audited, at least `least_pixels`
    int samples = 128; ///< paths of each of the two estimates of an audited pixel, on average, at least 16
    /// Pixels from which each audited one is chosen, by a glance of `glance_samples` paths, at least 2, at each. 1: none
    /// is passed over.
    int candidates = 16;
    int glance_samples = 8;
    std::uint32_t seed = 0; ///< audits of different seeds are independent
};

/// Fewer observations tell nothing about how far they are off.
constexpr int least_pixels = 16;

/// The light of a pixel, estimated from `samples` paths: linear RGB before exposure, with its variance. Estimates of
/// different seeds are independent of each other and of the picture. Called by several threads.
using PixelLight = std::function<reference::PixelEstimate(const reference::PixelTracer::Pixel&)>;

/// The error of a picture (RGBA before exposure, alpha: coverage by surfaces) against the light that `light` estimates:
/// the relative RMSE of RGB cut to [0, settings.cut], over the pixels whose alpha is above 0. Values of the picture that
/// are not finite count as 0. Returns nothing if fewer than `least_pixels` pixels are covered, or if their light is
/// black. The same for any number of threads.
///
/// Each audited pixel p is traced twice, with independent noise: the mean of (p - a)(p - b) is the mean square error
/// without bias from noise, whatever is wrong with the picture. What is wrong is often in few pixels: in `report`, one
/// percent of them holds nearly all of the squared error. So candidates are drawn half evenly, half by their contrast, and
/// one out of several is chosen at random in proportion to its error at a glance, weighted so that the mean stays
/// unbiased. [resampled importance sampling: Talbot, Cline and Egbert 2005] All candidates' mean error at a glance is
/// added to each of theirs, so that what is not seen at a glance counts too. The noise at the glance decides how many
/// samples the pixel gets, so that the few noisiest pixels are not all of the audit's own error.
///
/// The cut is applied to a and b, which are means of noisy samples: that of a mean near the cut is too low on average, by
/// up to 0.4 of its standard deviation. The jackknife over the halves of its samples takes away at least 0.4 of that
/// bias. [Quenouille 1956] What is left changes errors above 3 % by less than 2 % of themselves
/// (docs/AUDIT.md).
std::optional<Error> measure(const image::RadianceImage& picture, const Settings& settings,
                             const PixelLight& light);

/// The same against the light that the reference traces (reference::trace). Scene, panorama (null: black) and `truth`
/// describe the picture; limits and seed of `truth` have no effect. Throws as trace().
std::optional<Error> measure(const scene::Scene& scene, const image::RadianceImage* panorama,
                             const reference::Settings& truth, const image::RadianceImage& picture,
                             const Settings& settings);

} // namespace lambent::audit
