// Closed solids for furniture, with smooth normals, and texture coordinates in metres.
#pragma once

#include "scene/scene.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace lambent::kitchen {

/// A box with rounded edges.
struct BoxShape {
    glm::vec3 low{0.0f}, high{1.0f};
    float bevel = 0.0f;        ///< radius of the edges, metres, below half the shortest side; 0: sharp
    int steps = 1;             ///< triangles along half an edge's arc
    int grain = 1;             ///< the axis along which v runs; u runs across it
    glm::vec2 uv_offset{0.0f}; ///< metres
};
scene::Mesh make_box(const BoxShape& shape);

/// A profile turned around +Y: points (radius, height) with the outside on the right of the direction along them, as up
/// the outside of a cup and down its inside. Closed if it begins and ends at radius 0.
/// Corners sharper than `crease` (radians) stay sharp. u in turns, v in metres along the profile.
struct LatheShape {
    std::vector<glm::vec2> profile;
    int segments = 32;
    float crease = 0.6f;
};
scene::Mesh make_lathe(const LatheShape& shape);

/// A curve through the points [Catmull and Rom 1974], with `steps` segments between neighbours.
std::vector<glm::vec2> smooth(std::span<const glm::vec2> points, int steps);
std::vector<glm::vec3> smooth(std::span<const glm::vec3> points, int steps);

/// A polyline whose corners are replaced by arcs that begin `radius` before them and end `radius` after them.
std::vector<glm::vec3> rounded_path(std::span<const glm::vec3> points, float radius, int steps);

/// A tube along a path of two or more different points, with flat ends. Radii: one for all points, or one for each.
struct TubeShape {
    std::vector<glm::vec3> path;
    std::vector<float> radii;
    int segments = 12;
};
scene::Mesh make_tube(const TubeShape& shape);

/// A leaf or blade, two-sided if its material is: from the root along +Z, bending down by `droop` (radians
/// at the tip), folded a little along the middle.
struct LeafShape {
    float length = 0.2f, width = 0.06f;
    float droop = 0.8f;
    int steps = 8;
};
scene::Mesh make_leaf(const LeafShape& shape);

/// Appends `part`, moved by a rotation, translation and uniform scale, to `whole`.
void append(scene::Mesh& whole, const scene::Mesh& part, const glm::mat4& transform, const glm::vec4& tint);

} // namespace lambent::kitchen
