// What the corners of a primitive make: triangles, lines or points.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent::scene {

/// Fills the mesh's triangles, lines or points by the formulas of the specification for a mode, one of glTF's seven.
/// What a strip or fan repeats to turn a corner, and lines from a vertex to itself, are left out. Returns how many
/// corners are left over after the last whole triangle or line. [glTF 2.0, 3.7.2.1]
std::size_t connect(const std::vector<std::uint32_t>& corners, int mode, Mesh& mesh);

/// Many primitives may share one large set of vertices: where the mesh uses few of `vertices` of them, lists those that
/// it does, ascending, and makes its corners count them. Empty: it is to have all.
std::vector<std::uint32_t> choose_vertices(Mesh& mesh, std::size_t vertices);

} // namespace lambent::scene
