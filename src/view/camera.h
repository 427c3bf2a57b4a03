// The camera of a picture, and the rays through its pixels.
#pragma once

#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <limits>

namespace lambent::view {

/// A pose and a projection. right, up and back are orthonormal; the camera looks along -back.
struct Camera {
    glm::vec3 position{0.0f};
    glm::vec3 right{1.0f, 0.0f, 0.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};
    glm::vec3 back{0.0f, 0.0f, 1.0f};
    float vertical_fov = 0.7853982f; ///< radians, in (0, pi); 0 for an orthographic camera
    float vertical_size = 0.0f;      ///< metres from bottom to top, orthographic only
    /// Width / height of the view that every picture contains: a narrower picture shows more above and below. 0: the
    /// vertical extent is the same in every picture.
    float aspect = 0.0f;
    float near = 0.0f,
          far = std::numeric_limits<float>::infinity(); ///< clipping distances along -back, metres
};

/// An orbit: the camera's position relative to the point it looks at.
struct Orbit {
    float azimuth = 0.0f;   ///< radians about +Y; 0 is on the +Z side, a quarter turn on the +X side
    float elevation = 0.0f; ///< radians above the horizontal plane, in [-pi/2, pi/2]
    float distance = 0.0f;  ///< metres from the point looked at; 0: far enough to see the whole scene
};

/// A perspective camera on an orbit around the centre of `bounds`. At distance 0 it is as near as possible with all
/// corners of `bounds`, and a margin of a tenth, inside a picture of the given aspect (width / height).
Camera orbit_camera(const scene::Bounds& bounds, const Orbit& orbit, float vertical_fov, float aspect);

/// A camera of a glTF file.
Camera from_scene(const scene::Camera& camera);

/// Rays as a linear function of the position (x, y) in the picture, in pixels from the top left corner:
/// origin + x origin_dx + y origin_dy, and the same for the direction, which is not normalised.
struct RayMap {
    glm::vec3 origin{0.0f}, origin_dx{0.0f}, origin_dy{0.0f};
    glm::vec3 direction{0.0f}, direction_dx{0.0f}, direction_dy{0.0f};
    float near = 0.0f,
          far = std::numeric_limits<float>::infinity(); ///< the camera's, in multiples of the direction
    bool operator==(const RayMap& other) const = default;
};
RayMap ray_map(const Camera& camera, int width, int height);

} // namespace lambent::view
