// A drawn picture, as light.
#pragma once

#include "image/image.h"

#include <string>
#include <utility>
#include <vector>

namespace lambent::draw {

/// One layer of the G-buffer or one pass's light, for looking at.
struct Layer {
    enum class Kind {
        light,      ///< radiance: RGB
        irradiance, ///< lux for radiance in nits: RGB
        color,      ///< reflectance in [0, 1]: RGB
        normal,     ///< unit vector in the world: RGB = XYZ
        scalar,     ///< one value in [0, 1], three times
        exponent,   ///< Phong exponent, three times
        depth,      ///< metres from the camera, three times; 0 where nothing is
    };
    std::string name;
    Kind kind = Kind::light;
    image::RadianceImage image; ///< RGBA; alpha is coverage
};

struct Frame {
    image::RadianceImage radiance; ///< RGBA, before exposure and tone curve; alpha is coverage by surfaces
    std::vector<Layer> layers;     ///< when asked for; the light layers add up to `radiance`

    /// Passes of a device and the milliseconds that each took there; none from the CPU renderer.
    std::vector<std::pair<std::string, double>> passes;
};

} // namespace lambent::draw
