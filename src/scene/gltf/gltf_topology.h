// Triangles, lines and points from the vertex indices of a primitive.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lambent::scene {

/// The primitive restart index, which is the largest number of a component type: it is no vertex, but ends one strip,
/// fan, loop, line or triangle and begins another. [glTF 2.0, 3.7.2.1; OpenGL 4.6, 10.3.6]
std::uint32_t restart_index(int component_type);

/// Numbers of indices that are part of no triangle, line or point.
struct UnusedCorners {
    std::size_t left_over = 0; ///< after the last whole triangle or line; 0 where there are restarts
    std::size_t restarts = 0;
};

/// Adds triangles, lines or points to the mesh by the formulas of the specification for a mode, one of glTF's seven.
/// Indices equal to `restart` end the current strip, fan, loop, line or triangle. Triangles of strips and fans that
/// repeat a vertex, and lines from a vertex to itself, are left out. [glTF 2.0, 3.7.2.1]
UnusedCorners connect(std::span<const std::uint32_t> corners, std::uint32_t restart, int mode, Mesh& mesh);

/// Selects the vertices that the mesh uses, for many primitives may share one large list of `vertices`. If it has
/// fewer corners than that, returns the indices of the used vertices, ascending, and renumbers its corners; else
/// returns an empty list, for all.
std::vector<std::uint32_t> choose_vertices(Mesh& mesh, std::size_t vertices);

} // namespace lambent::scene
