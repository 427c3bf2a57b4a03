// Where the rays of a picture start and go.
#pragma once

#include "view/camera.h"

#include <glm/ext/vector_double3.hpp>

#include <limits>
#include <optional>

namespace lambent::reference {

struct SightRay {
    glm::dvec3 origin{0.0}, direction{0.0};                           ///< direction of unit length
    double near = 0.0, far = std::numeric_limits<double>::infinity(); ///< along it, metres
};

/// A camera, or all directions from one point.
class Lens {
public:
    Lens(const view::Camera& camera, int width, int height);

    /// A panorama, oriented as equations/sphere_maps.glsl says.
    Lens(const glm::vec3& viewpoint, int width, int height);

    /// Through the place (x, y), in pixels from the top left corner.
    SightRay through(double x, double y) const;

private:
    std::optional<view::RayMap> map_; ///< none: a panorama
    glm::dvec3 viewpoint_{0.0};
    int width_, height_;
};

} // namespace lambent::reference
