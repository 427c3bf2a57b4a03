// Instances of a node's mesh. [EXT_mesh_gpu_instancing]
#pragma once

#include "scene/gltf_document/gltf_document.h"
#include "scene/gltf_document/gltf_losses.h"

#include <glm/ext/matrix_double4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace lambent::scene {

/// Transforms relative to a node. Lists that the file does not give are empty: no translation, rotation or scale.
struct NodeInstances {
    std::size_t count = 0;
    std::vector<glm::vec3> translations;
    std::vector<glm::vec4> rotations; ///< quaternions, xyzw, of any length
    std::vector<glm::vec3> scales;

    /// Node from mesh; not finite where the file's numbers are not, or a rotation has no length.
    glm::dmat4 transform(std::size_t instance) const;
};

/// The instances that the extension gives a node; nothing if it gives none. Attributes of unequal counts are read up
/// to the smallest, and at most `most` instances, each with a warning. If an attribute cannot be read, nothing is
/// returned, with a warning, and the mesh is drawn once, as without the extension.
std::optional<NodeInstances> read_instances(const Document& document, int node, std::size_t most,
                                            Losses& losses);

} // namespace lambent::scene
