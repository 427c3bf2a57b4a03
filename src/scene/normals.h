// Vertex normals where a file has none, or broken ones.
#pragma once

#include "scene/scene.h"

#include <cstddef>

namespace lambent::scene {

/// Gives each triangle its own vertices with the face's normal, counter-clockwise side outwards: what glTF
/// asks for where normals are missing. [glTF 2.0, 3.7.2.1] Existing normals and tangents are dropped. A
/// triangle without area gets +Z.
void make_flat_normals(Mesh& mesh);

/// Brings every normal to unit length. One of length zero, or not finite, is rebuilt as the sum of the
/// adjacent faces' normals weighted by their angle at the vertex (Thurmer and Wuthrich, "Computing Vertex
/// Normals from Polygonal Facets", 1998), +Z where that vanishes too. Returns how many were rebuilt.
/// Positions must be finite, triangles in range, normals one a vertex.
std::size_t repair_normals(Mesh& mesh);

} // namespace lambent::scene
