// What camera rays meet first, as a denoiser has to know it.
#pragma once

#include "image/image.h"

#include <glm/ext/vector_double3.hpp>

#include <vector>

namespace lambent::reference {

/// What one camera ray meets first. All 0 where it meets nothing and the background carries no noise of its own.
struct FirstSurface {
    /// Radiance that arrives without being reflected: of an emissive or unlit surface, or of a sharp background.
    glm::dvec3 emitted{0.0};
    /// Share of white light from everywhere that the surface sends along the ray, 0 to 1 or a little above. A blurred
    /// background, which is noisy, has 1; unlit surfaces have 0.
    glm::dvec3 albedo{0.0};
    glm::dvec3 normal{0.0}; ///< unit shading normal on the viewer's side; 0 of a background
    double depth = 0.0;     ///< metres along the ray; 0 of a background
};

/// Means of FirstSurface over the samples of each pixel, rows from the top.
struct FirstSurfaces {
    image::RadianceImage emitted, albedo; ///< RGB
    /// RGB variance of the reflected light (radiance less emitted) as a multiple of the albedo: how much albedo and
    /// coverage vary within the pixel is no part of it. Infinite after one sample.
    image::RadianceImage variance;
    image::RadianceImage normal; ///< X, Y, Z, shorter than 1 where normals differ or a part is background
    std::vector<float> depth;    ///< of background counted as 0
    std::vector<int> samples;    ///< of each pixel, at least 1
};

} // namespace lambent::reference
