// What the corners of a primitive make: triangles, lines or points.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lambent::scene {

/// The largest number of a component type: as an index it is no vertex, but ends one strip, fan, loop, line or triangle and
/// begins another. [glTF 2.0, 3.7.2.1; OpenGL 4.6, 10.3.6]
std::uint32_t restart_index(int component_type);

/// Corners of which nothing is made.
struct UnusedCorners {
    std::size_t left_over = 0; ///< after the last whole triangle or line; 0 where there are restarts
    std::size_t restarts = 0;
};

/// Adds to the mesh's triangles, lines or points by the formulas of the specification for a mode, one of glTF's seven.
/// Corners that are `restart` end what they are in. What a strip or fan repeats to turn a corner, and lines from a vertex
/// to itself, are left out. [glTF 2.0, 3.7.2.1]
UnusedCorners connect(std::span<const std::uint32_t> corners, std::uint32_t restart, int mode, Mesh& mesh);

/// Many primitives may share one large set of vertices: where the mesh uses few of `vertices` of them, lists those that
/// it does, ascending, and makes its corners count them. Empty: it is to have all.
std::vector<std::uint32_t> choose_vertices(Mesh& mesh, std::size_t vertices);

} // namespace lambent::scene
