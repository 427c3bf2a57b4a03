// A drawn picture as linear radiance, with its layers.
#pragma once

#include "image/image.h"

#include <string>
#include <utility>
#include <vector>

namespace lambent::draw {

/// A column of the G-buffer or the light of one pass as an image, for inspection.
struct Layer {
    enum class Kind {
        light,      ///< radiance, RGB
        irradiance, ///< RGB, in lux if radiance is in nits
        color,      ///< reflectance in [0, 1], RGB
        normal,     ///< unit vector in world space, RGB = XYZ
        scalar,     ///< one value in [0, 1], the same in R, G and B
        exponent,   ///< Phong exponent, the same in R, G and B
        depth,      ///< metres from the camera, the same in R, G and B; 0 where there is no surface
    };
    std::string name;
    Kind kind = Kind::light;
    image::RadianceImage image; ///< RGBA; alpha is coverage
};

/// A drawn picture.
struct Frame {
    image::RadianceImage radiance; ///< RGBA, before exposure and tone curve; alpha is coverage by surfaces
    std::vector<Layer> layers;     ///< if Settings::layers is set; those named light_* add up to `radiance`

    /// Name and duration, in milliseconds, of each pass on a device; empty for the CPU renderer.
    std::vector<std::pair<std::string, double>> passes;
};

} // namespace lambent::draw
