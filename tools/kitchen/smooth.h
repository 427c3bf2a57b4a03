// Removes noise from a traced panorama.
#pragma once

#include "kitchen/first_hits.h"
#include "image/image.h"

#include <span>

namespace lambent {

/// Averages the radiance (RGB or RGBA; RGB is returned) of pixels that show the same surface and differ by no more than
/// their variance explains: textures and edges are kept, the light on them is smoothed.
/// [Dammertz et al. 2010, "Edge-avoiding a-trous wavelet transform for fast global illumination filtering"; guided by
/// variance as in Schied et al. 2017, "Spatiotemporal variance-guided filtering"]
image::RadianceImage smoothed(const image::RadianceImage& radiance, const image::RadianceImage& variance,
                              std::span<const FirstHit> hits);

} // namespace lambent
