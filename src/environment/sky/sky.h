// The built-in environment "sky".
#pragma once

#include "image/image.h"

namespace lambent::environment {

/// Luminance in cd/m^2 of radiance 1: a white wall in the sun is then 3, the blue sky 0.3 to 1.
constexpr float sky_nits_per_unit = 15000.0f;

/// As BuiltinOptions, within their ranges.
struct SkyOptions {
    int width;
    float sun_azimuth, sun_elevation; ///< radians
    float turbidity;
};
image::RadianceImage make_sky(const SkyOptions& options);

} // namespace lambent::environment
