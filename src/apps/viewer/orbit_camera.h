// The camera of a viewer: on an orbit around a target, moved by mouse and keys.
#pragma once

#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace lambent::viewer {

/// Limits of moves, in radii of the scene (half the diagonal of its bounding box).
struct EyeLimits {
    static constexpr double nearest = 1e-3, farthest = 100.0, target = 20.0;
};

/// Angles are in degrees, lengths in metres, targets in world space.
class OrbitCamera {
public:
    OrbitCamera() = default;
    OrbitCamera(double azimuth, double elevation) : azimuth_(azimuth), elevation_(elevation) {}

    /// At a distance above 0 from the target, which is the middle of the scene if none is given.
    OrbitCamera(double azimuth, double elevation, double distance, const std::optional<glm::dvec3>& target)
        : azimuth_(azimuth), elevation_(elevation), distance_(distance), target_(target)
    {
    }

    /// The scene that moves are relative to: its bounding box, relative to its origin, and the distance of the camera
    /// from the middle of the box when all of it is in view.
    struct World {
        scene::Bounds bounds;
        double framing_distance = 1.0;
        glm::dvec3 origin{0.0}; ///< of the scene, in world space
    };

    /// Turns around the target; the elevation is clamped at the poles.
    void orbit(double azimuth, double elevation);

    /// Moves right and up, in heights of the picture at the depth of the target: a point there follows the pointer.
    void pan(const World& world, double right, double up, double vertical_fov);

    /// Multiplies the distance by exp(amount): below 0 the camera comes nearer.
    void dolly(const World& world, double amount);

    /// Makes a point the target, and so the middle of the picture.
    void look_at(const World& world, const glm::dvec3& point);

    /// "--camera" and "--target" of `lambent render`, to six digits, a target to a millionth of the distance. Until
    /// target or distance are changed only the angles are given, and the command frames the scene.
    std::vector<std::string> options() const;

    double azimuth() const { return azimuth_; }
    double elevation() const { return elevation_; }
    double distance(const World& world) const { return distance_.value_or(world.framing_distance); }
    glm::dvec3 target(const World& world) const;

private:
    void fix(const World& world);

    double azimuth_ = 0.0, elevation_ = 0.0;
    std::optional<double> distance_;
    std::optional<glm::dvec3> target_;
};

/// Half the diagonal of the box, at least 1e-6; 1 for an empty box.
double radius_of(const scene::Bounds& bounds);

/// The middle of the box; the origin for an empty box.
glm::dvec3 middle_of(const scene::Bounds& bounds);

} // namespace lambent::viewer
