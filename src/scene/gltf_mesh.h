// Meshes and where they stand.
#pragma once

#include "scene/gltf_document.h"
#include "scene/gltf_material.h"
#include "scene/gltf_nodes.h"

#include <vector>

namespace lambent::scene {

struct DrawnMeshes {
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
    MaterialTable materials;
};

/// Reads every primitive under the drawn nodes once for all nodes that share it; skinned ones, and those
/// whose node has morph weights of its own, once for each node. In parallel. Nodes with a singular
/// transform are left out with a warning. Throws Error(bad_input), also where sharing would blow a small
/// file up into unreasonably much geometry.
DrawnMeshes read_meshes(const Document& document, const NodeTree& nodes, Warnings& warnings);

} // namespace lambent::scene
