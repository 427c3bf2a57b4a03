// The meshes of the drawn nodes, and their instances.
#pragma once

#include "scene/gltf_document/gltf_document.h"
#include "scene/gltf/gltf_material.h"
#include "scene/gltf/gltf_nodes.h"

#include "scene/gltf/gltf_primitive.h"

#include <optional>
#include <vector>

namespace lambent::scene {

struct DrawnMeshes {
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
    MaterialTable materials;
};

/// The result of each primitive whose shape no animation changes; none for others.
using StillShapes = std::vector<std::optional<PrimitiveResult>>;

/// Shapes that the poses of one file share.
struct ShapeStore {
    const StillShapes* known = nullptr; ///< those kept by another pose, which are not read again; null: none
    StillShapes* keep = nullptr;        ///< receives those of this pose; null: they are not kept
};

/// Reads the primitives of the drawn nodes, in parallel: each once for all nodes that share it, but skinned ones, and
/// those whose node has its own or animated morph weights, once per node. Nodes and instances with a singular
/// transform are left out with a warning; in a file with animations they refer to an empty mesh, the last one,
/// instead, so that meshes, instances and materials are the same at every moment. Primitives, or parts of them, that
/// cannot be read are left out with a warning. Throws Error(bad_input) if that leaves nothing to draw, and if sharing
/// would expand a small file to unreasonably much geometry.
DrawnMeshes read_meshes(const Document& document, const NodeTree& nodes, const ShapeStore& shapes,
                        Warnings& warnings);

} // namespace lambent::scene
