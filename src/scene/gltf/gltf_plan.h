// The plan of the primitives that are read, and of the nodes that show them.
#pragma once

#include "scene/gltf/gltf_instancing.h"
#include "scene/gltf_document/gltf_losses.h"
#include "scene/gltf/gltf_nodes.h"
#include "scene/gltf/gltf_primitive.h"

#include <glm/mat4x4.hpp>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace lambent::scene {

/// Not copyable, since requests refer to `skins`.
struct Plan {
    struct Use {
        int node;
        std::size_t request;
        int instance = -1; ///< of the node's own instances; -1: it has none
    };

    std::vector<PrimitiveRequest> requests;
    std::vector<int> materials; ///< of each request, the file's index
    std::vector<bool> still;    ///< of each request, whether its shape is the same at every moment
    std::vector<Use> uses;
    std::map<int, NodeInstances> instances; ///< by node
    /// By skin: world from mesh for each joint; empty if it is broken.
    std::map<int, std::vector<glm::mat4>> skins;
    std::size_t without_positions = 0; ///< primitives left out
    std::size_t odd_weights = 0;       ///< primitives with another number of targets than weights
    std::string first_loss;            ///< the first fault that cost a primitive or mesh; empty: none

    Plan() = default;
    Plan(Plan&&) = default;
    Plan& operator=(Plan&&) = default;
};

/// Visits the drawn nodes. Meshes, skins and nodes' own instances that cannot be read are left out with a warning.
/// Throws Error(bad_input) for too many instances.
Plan make_plan(const Document& document, const NodeTree& nodes, Losses& losses);

} // namespace lambent::scene
