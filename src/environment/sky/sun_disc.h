// Adds the sun to the texels of a panorama.
#pragma once

#include "environment/panorama/packed_texel.h"
#include "image/image.h"

namespace lambent::environment {

struct SunDisc {
    double azimuth = 0.0;     ///< radians, in the panorama: 0 in its middle column, growing to the right
    double elevation = 0.0;   ///< radians above the horizontal
    double ground_edge = 0.0; ///< elevation below which the disc is hidden
    Rgb irradiance;           ///< of a surface facing the whole disc
};

/// Adds a disc of 0.53 degrees, darker towards its limb. Each point of it is shared between the four nearest texels by
/// bilinear weights, so that at any width the sum of radiance times solid angle is the irradiance (of the part that is
/// not hidden), and its centroid is where the sun is.
/// [limb: Hestroffer and Magnan 1998, "Wavelength dependency of the solar limb darkening", at 550 nm]
void add_sun(const SunDisc& sun, image::RadianceImage& panorama);

} // namespace lambent::environment
