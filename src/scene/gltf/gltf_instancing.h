// The places where a node shows its mesh. [EXT_mesh_gpu_instancing]
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

/// Transforms within a node; what a file leaves out is empty and stands for none.
struct NodeInstances {
    std::size_t count = 0;
    std::vector<glm::vec3> translations;
    std::vector<glm::vec4> rotations; ///< quaternions, xyzw, of any length
    std::vector<glm::vec3> scales;

    /// Node from mesh; not finite where the file's numbers are not, or a rotation has no length.
    glm::dmat4 transform(std::size_t instance) const;
};

/// What the extension says of a node; none where it says nothing. Attributes of unequal counts are read up to the
/// smallest, and no more than `most` instances, each with a warning. Where one cannot be read the mesh is shown once, as
/// without the extension, with a warning.
std::optional<NodeInstances> read_instances(const Document& document, int node, std::size_t most,
                                            Losses& losses);

} // namespace lambent::scene
