// A photographer's softbox: a rounded rectangle that emits light.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lambent::environment {

/// A softbox facing the origin, where the object stands. Lengths in metres.
struct Softbox {
    glm::vec3 centre;
    glm::vec2 half_size;  ///< to the right and up
    float corner = 0.05f; ///< radius of the corners
    float frame = 0.02f;  ///< width of the dark cloth around it
    glm::vec3 radiance;   ///< in the middle
    float edge = 0.5f;    ///< radiance at the corners, relative to that in the middle
    float roll = 0.0f;    ///< radians by which it is turned in its plane
};

/// A softbox with the frame in which it is seen from the origin.
class PlacedSoftbox {
public:
    explicit PlacedSoftbox(const Softbox& box);

    /// Radiance from a unit direction; `behind` is that without the softbox. Edges are soft over an angle of `texel`
    /// radians.
    glm::vec3 over(const glm::vec3& behind, const glm::vec3& direction, float texel) const;

private:
    Softbox box_;
    glm::vec3 towards_, right_, up_;
    float distance_;
    float reach_; // cosine of the angle beyond which nothing of it is seen
};

} // namespace lambent::environment
