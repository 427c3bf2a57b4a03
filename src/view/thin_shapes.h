// Triangles one pixel wide for points and lines.
#pragma once

#include "scene/scene.h"
#include "view/camera.h"

#include <glm/ext/matrix_double3x3.hpp>
#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/ext/vector_double4.hpp>

#include <array>

namespace lambent::view {

/// Turns points into squares and lines into strips one pixel wide, parallel to the image plane, with their front sides
/// towards the camera. Parts outside the picture are left out.
///
/// Each is wider than a pixel by 1/256 on both sides, so that in spite of rounding a line between two rows of pixels
/// is hit by the rays through the centres of both rows, and not by none.
class ThinShapes {
public:
    /// For a picture of this size in pixels.
    ThinShapes(const RayMap& rays, int width, int height);

    /// Triangles, in world space, for the points and lines of a mesh whose world from mesh is `transform`. Where the
    /// mesh has no normals, they face the camera; normals of a shape that is seen from behind are reversed.
    scene::Mesh of(const scene::Mesh& mesh, const glm::mat4& transform) const;

private:
    struct Line;
    class Builder;

    /// (t, x, y) of a point P: the ray through the position (x, y) in the picture reaches P at distance t. In a
    /// perspective, x and y are multiplied by t, so that all three are linear in P.
    glm::dvec3 seen(const glm::dvec3& point) const { return inverse_ * (point - origin_); }
    glm::dvec3 point(const glm::dvec3& seen) const { return origin_ + rays_ * seen; }
    /// The factor of x and y in (t, x, y).
    double share(const glm::dvec3& seen) const { return perspective_ ? seen.x : 1.0; }
    bool clip(Line& line) const;

    glm::dvec3 origin_;
    /// Columns: the ray's direction, and its change (orthographic: of its origin) per pixel to the right and down.
    glm::dmat3 rays_, inverse_{1.0};
    glm::dvec3 facing_{0.0};            ///< towards the camera, unit length
    std::array<glm::dvec4, 5> sides_{}; ///< planes of the view volume over (t, x, y, 1): 0 or more inside
    bool perspective_, usable_;
};

} // namespace lambent::view
