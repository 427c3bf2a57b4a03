// Morph targets and skins, applied for a pose of the nodes.
#pragma once

#include "scene/gltf_document/gltf_document.h"
#include "scene/scene.h"
#include "scene/gltf_document/gltf_losses.h"
#include "scene/gltf/gltf_nodes.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lambent::scene {

/// One primitive of the file, and which of its vertices are read (ascending; empty: all).
struct PrimitivePart {
    const gltf::Primitive& primitive;
    std::string name; ///< "mesh 0, primitive 1"
    std::span<const std::uint32_t> selection;
};

/// Adds the weighted displacements of positions, normals and tangents. Targets without a weight count as 0, and
/// surplus weights are ignored. Displacements that cannot be read are left out with a warning. Returns how many
/// displacements of other attributes were left out.
std::size_t apply_morph_targets(const Document& document, const PrimitivePart& part,
                                std::span<const double> weights, Losses& losses, Mesh& mesh);

/// World from mesh for each joint of a skin, in the pose of the nodes. Throws Error(bad_input) for joints or inverse
/// bind matrices that do not exist or are not finite.
std::vector<glm::mat4> skin_matrices(const Document& document, const NodeTree& nodes, int skin);

bool has_skin_attributes(const gltf::Primitive& primitive);

/// Transforms the vertices into the world by their joints. Where a transform mirrors, the winding of triangles is
/// reversed, so that their front sides stay the same. Vertices whose weights sum to 0 follow their first joint. Throws
/// Error(bad_input), before any change, for a joint that the skin does not have or a weight that is not finite.
void apply_skin(const Document& document, const PrimitivePart& part, std::span<const glm::mat4> matrices,
                Mesh& mesh);

} // namespace lambent::scene
