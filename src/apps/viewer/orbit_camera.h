// Where the viewer looks from: an orbit about a point, moved by hands.
#pragma once

#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace lambent::viewer {

/// How far moves may lead, in radii of the scene (half its box's diagonal).
struct EyeLimits {
    static constexpr double nearest = 1e-3, farthest = 100.0, target = 20.0;
};

/// Angles in degrees, lengths in metres; targets are points of the world.
class OrbitCamera {
public:
    OrbitCamera() = default;
    OrbitCamera(double azimuth, double elevation) : azimuth_(azimuth), elevation_(elevation) {}

    /// At a distance above 0 from a point; without one from the scene's middle.
    OrbitCamera(double azimuth, double elevation, double distance, const std::optional<glm::dvec3>& target)
        : azimuth_(azimuth), elevation_(elevation), distance_(distance), target_(target)
    {
    }

    /// What moves are measured by: the scene's box, from its origin, and how far the eye is from its middle when it
    /// frames all.
    struct World {
        scene::Bounds bounds;
        double framing_distance = 1.0;
        glm::dvec3 origin{0.0}; ///< of the scene, in the world
    };

    /// Around the target; the elevation ends at the poles.
    void orbit(double azimuth, double elevation);

    /// By parts of the picture's height, right and up, at the target's depth: what is there follows the hand.
    void pan(const World& world, double right, double up, double vertical_fov);

    /// The distance times exp(amount): below 0 comes nearer.
    void dolly(const World& world, double amount);

    /// A point becomes the middle of the picture.
    void look_at(const World& world, const glm::dvec3& point);

    /// "--camera" and "--target" of `lambent render`, to six digits; a target to a millionth of the distance. Without
    /// moves of the target or the distance the scene is framed.
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

/// Half the diagonal of the box; 1 for an empty one, never 0.
double radius_of(const scene::Bounds& bounds);

/// The middle of the box; the origin for an empty one.
glm::dvec3 middle_of(const scene::Bounds& bounds);

} // namespace lambent::viewer
