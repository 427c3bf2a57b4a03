// Points and lines as a picture shows them: triangles one pixel wide.
#pragma once

#include "scene/scene.h"
#include "view/camera.h"

#include <glm/ext/matrix_double3x3.hpp>
#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/ext/vector_double4.hpp>

#include <array>

namespace lambent::view {

/// Turns points into squares and lines into strips one pixel wide, parallel to the picture, with their fronts towards its
/// camera. What is not in the picture is left out.
///
/// Each is wider than a pixel by 1/256 on both sides: however numbers are rounded, a line between two rows of pixels is
/// seen by rays through the middles of both, not of none.
class ThinShapes {
public:
    /// Of a picture of that size in pixels.
    ThinShapes(const RayMap& rays, int width, int height);

    /// The points and lines of a mesh that `transform` places in the world, in the world. Normals, where the mesh has none,
    /// face the camera; those of a shape that is seen from behind are turned round.
    scene::Mesh of(const scene::Mesh& mesh, const glm::mat4& transform) const;

private:
    struct Line;
    class Builder;

    /// (t, x, y) of a point P: the ray through the place (x, y) reaches it at the distance t. x and y are multiplied by t
    /// in a perspective, so that all three are linear in P.
    glm::dvec3 seen(const glm::dvec3& point) const { return inverse_ * (point - origin_); }
    glm::dvec3 point(const glm::dvec3& seen) const { return origin_ + rays_ * seen; }
    double share(const glm::dvec3& seen) const
    {
        return perspective_ ? seen.x : 1.0;
    } ///< of x and y in those
    bool clip(Line& line) const;

    glm::dvec3 origin_;
    glm::dmat3 rays_, inverse_{1.0};    ///< columns: direction, and what a step to the right and down adds
    glm::dvec3 facing_{0.0};            ///< towards the camera, unit length
    std::array<glm::dvec4, 5> sides_{}; ///< of what is seen, over (t, x, y, 1): 0 or more inside
    bool perspective_, usable_;
};

} // namespace lambent::view
