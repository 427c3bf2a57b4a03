// Noise taken out of a traced panorama.
#pragma once

#include "kitchen/first_hits.h"
#include "image/image.h"

#include <span>

namespace lambent {

/// The radiance (RGB or RGBA; RGB is returned) with its noise averaged out among pixels that show the same surface and
/// differ by no more than their variance explains: textures and edges stay, the light on them is smoothed.
/// [Dammertz et al. 2010, "Edge-avoiding a-trous wavelet transform for fast global illumination filtering"; guided by
/// variance as in Schied et al. 2017, "Spatiotemporal variance-guided filtering"]
image::RadianceImage smoothed(const image::RadianceImage& radiance, const image::RadianceImage& variance,
                              std::span<const FirstHit> hits);

} // namespace lambent
