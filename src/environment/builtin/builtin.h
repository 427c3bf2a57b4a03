// Environments that need no file.
#pragma once

#include "image/image.h"

#include <span>
#include <string_view>

namespace lambent::environment {

struct BuiltinOptions {
    int width =
        0; ///< of the panorama, a power of two from 64 to 8192; half as high. 0: 1024, for the kitchen 2048
    float sun_azimuth = -0.8f;  ///< radians about +Y as a camera's azimuth: 0 is on the +Z side (sky)
    float sun_elevation = 0.7f; ///< radians above the horizon, -0.1 to pi/2 (sky)
    float turbidity = 2.2f;     ///< haze: 1.5 (clear) to 10 (sky)
};

/// The names that make_builtin knows:
///  - kitchen: a modern kitchen on a sunny day, path-traced from a model of one (tools/kitchen);
///  - studio: a dark photographer's studio with softboxes, for products;
///  - sky: a clear day with the sun, over ground;
///  - furnace: radiance 1 everywhere.
std::span<const std::string_view> builtin_names();

bool is_builtin(std::string_view name);

/// An equirectangular RGB image, oriented as Panorama. Throws Error(usage) for an unknown name or an option outside
/// its range. Takes some tens of milliseconds at the default width on two cores.
image::RadianceImage make_builtin(std::string_view name, const BuiltinOptions& given = {});

} // namespace lambent::environment
