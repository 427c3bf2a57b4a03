// The shape of a highlight on level ground.
#pragma once

#include "image/image.h"
#include "view/camera.h"

namespace lambent::report {

struct Oval {
    double on_ground = 0.0;  ///< longest over shortest axis, in metres of the plane y = 0
    double in_picture = 0.0; ///< the same in pixels
};

/// The shape of the pixels with at least half of the brightest pixel's luminance: the square root of the ratio of their
/// second moments along the two principal axes. 0 where there are fewer than three such pixels.
Oval highlight_shape(const image::RadianceImage& light, const view::Camera& camera);

} // namespace lambent::report
