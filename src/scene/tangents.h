// Tangent frames for normal maps.
#pragma once

#include "scene/scene.h"

#include <cstddef>

namespace lambent::scene {

/// Computes mesh.tangents from positions, unit normals and texture coordinates `set` transformed by `uv_transform`:
/// where KHR_texture_transform rotates the normal map, the tangent frame rotates with it.
///
/// After Mikkelsen, "Simulation of Wrinkled Surfaces Revisited" (2008): each corner takes the direction in which u
/// grows on its triangle, projected onto the plane of its normal; corners that share position, normal and texture
/// coordinates are averaged, weighted by the triangle's angle at the corner, separately for triangles with a mirrored
/// texture. Vertices shared by both kinds are split. Unlike in his code, triangles need only share the vertex, not an
/// edge. Triangles without area in the texture take the frame of a neighbour.
///
/// tangent.xyz has unit length and is perpendicular to the normal; the bitangent cross(normal, tangent) * w points
/// towards smaller v, up in the image, as glTF defines for normal maps. [glTF 2.0, 3.7.2.1 and 3.9.3]
void make_tangents(Mesh& mesh, int set, const glm::mat3& uv_transform);

/// Makes given tangents usable: unit length, w either 1 or -1. A tangent that has no length, is not finite or is
/// parallel to the (unit) normal is replaced by some perpendicular direction. Returns how many were replaced.
std::size_t repair_tangents(Mesh& mesh);

} // namespace lambent::scene
