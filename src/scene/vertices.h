// Rearranging the vertices of a mesh.
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <span>

namespace lambent::scene {

/// Replaces every per-vertex array of `mesh` by its elements at `source`: vertex i becomes a copy of old
/// vertex source[i]. Triangles do not change. Every entry must be below positions.size().
void gather_vertices(Mesh& mesh, std::span<const std::uint32_t> source);

/// Gives every triangle corner a vertex of its own, in order: triangle i becomes (3i, 3i+1, 3i+2).
void split_all_vertices(Mesh& mesh);

/// Appends a copy of each listed vertex to every per-vertex array.
void append_copies(Mesh& mesh, std::span<const std::uint32_t> source);

} // namespace lambent::scene
