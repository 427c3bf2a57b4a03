// The Utah teapot.
#pragma once

#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <array>

namespace lambent::scene {

/// Control points of a bicubic Bezier patch: four rows of four.
using BezierPatch = std::array<std::array<glm::dvec3, 4>, 4>;

/// Martin Newell's teapot of 1975 as 32 patches, in his units, +Z up, with the numbers published since F. Crow, "The
/// Origins of the Teapot" (IEEE Computer Graphics and Applications, 1987): with the bottom, which some listings lack,
/// and in the familiar squat proportions (the pot that Newell drew is 1.3 times as tall). Order: rim, upper body,
/// lower body, handle, spout, knob, lid, bottom, 4 each. cross(derivative along a row, derivative along a column)
/// points outwards. The bottom patches run from the foot to the centre, opposite to the usual order.
std::array<BezierPatch, 32> teapot_patches();

/// Metres per unit of Newell's: the teapot is 0.296 m long and 0.145 m tall.
inline constexpr double teapot_scale = 0.046;

/// The teapot in metres, +Y up, standing on y = 0, spout towards +X, each patch as subdivisions x
/// subdivisions squares (1 or more) without degenerate triangles: 64 n^2 - 8 n triangles. Normals come from
/// the patches' derivatives. u runs along the rows of a patch, v along its columns. Material 0.
Mesh make_teapot(int subdivisions);

} // namespace lambent::scene
