// Camera rays of a picture.
#pragma once

#include "view/camera.h"

#include <glm/ext/vector_double3.hpp>

#include <limits>
#include <optional>

namespace lambent::reference {

struct SightRay {
    glm::dvec3 origin{0.0}, direction{0.0};                           ///< direction has unit length
    double near = 0.0, far = std::numeric_limits<double>::infinity(); ///< limits along the direction, metres
};

/// Rays of a camera, or in all directions from one point.
class Lens {
public:
    Lens(const view::Camera& camera, int width, int height);

    /// An equirectangular panorama, oriented as in equations/sphere_maps.glsl.
    Lens(const glm::vec3& viewpoint, int width, int height);

    /// The ray through position (x, y), in pixels from the top left corner.
    SightRay through(double x, double y) const;

private:
    std::optional<view::RayMap> map_; ///< empty for a panorama
    glm::dvec3 viewpoint_{0.0};
    int width_, height_;
};

} // namespace lambent::reference
