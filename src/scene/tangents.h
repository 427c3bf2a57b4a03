// Tangent frames for normal maps.
#pragma once

#include "scene/scene.h"

#include <cstddef>

namespace lambent::scene {

/// Computes mesh.tangents from positions, unit normals and texture coordinates `set`, after `uv_transform`
/// has been applied to them: where a KHR_texture_transform turns the normal map, the frame turns with it.
///
/// After Mikkelsen, "Simulation of Wrinkled Surfaces Revisited" (2008): each corner takes the direction in
/// which u grows on its triangle, projected onto the plane of its normal; corners that share position,
/// normal and texture coordinates are averaged by the angle of the triangle at the corner, separately for
/// triangles whose texture lies mirrored. Vertices shared by both kinds are split. Unlike his code,
/// triangles need only share the vertex, not an edge. Triangles without area in the texture take the frame
/// of a neighbour.
///
/// tangent.xyz is of unit length and perpendicular to the normal; the bitangent cross(normal, tangent) * w
/// points where v shrinks, up in the image, as glTF's normal maps count. [glTF 2.0, 3.7.2.1 and 3.9.3]
void make_tangents(Mesh& mesh, int set, const glm::mat3& uv_transform);

/// Makes given tangents usable: unit length, w either 1 or -1. Where the vector has no length, is not
/// finite or runs along the (unit) normal, any perpendicular direction. Returns how many were replaced like
/// that.
std::size_t repair_tangents(Mesh& mesh);

} // namespace lambent::scene
