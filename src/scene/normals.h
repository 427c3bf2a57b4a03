// Vertex normals for meshes that have none, and repair of broken ones.
#pragma once

#include "scene/scene.h"

#include <cstddef>

namespace lambent::scene {

/// Gives each triangle its own vertices with the normal of its counter-clockwise side, as glTF requires where normals
/// are missing. [glTF 2.0, 3.7.2.1] Existing normals and tangents are dropped. A triangle without area gets +Z.
void make_flat_normals(Mesh& mesh);

/// Scales every normal to unit length. A normal of length zero, or not finite, is rebuilt as the sum of the adjacent
/// faces' normals weighted by their angle at the vertex (Thurmer and Wuthrich, "Computing Vertex Normals from
/// Polygonal Facets", 1998), or +Z where that vanishes too. Returns how many were rebuilt. Positions must be finite,
/// triangles in range, and there must be one normal per vertex.
std::size_t repair_normals(Mesh& mesh);

} // namespace lambent::scene
