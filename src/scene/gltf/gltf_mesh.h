// Meshes and where they stand.
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

/// What read_meshes made of each primitive whose shape no animation changes; none: it may change.
using StillShapes = std::vector<std::optional<PrimitiveResult>>;

/// Shapes that go from pose to pose of one file.
struct ShapeStore {
    const StillShapes* known = nullptr; ///< what another pose kept, if any: not read again
    StillShapes* keep = nullptr;        ///< where this one shall keep them, if anywhere
};

/// Reads every primitive under the drawn nodes once for all nodes that share it; skinned ones, and those
/// whose node has morph weights of its own or animated ones, once for each node. In parallel. Nodes, and instances of
/// theirs, with a singular transform are left out with a warning; where the file has animations they show an empty mesh, the last
/// one, instead: its meshes, instances and materials are the same ones at every moment. Primitives, or parts of them,
/// that cannot be read are left out with a warning. Throws Error(bad_input) where that leaves nothing to draw, and where
/// sharing would blow a small file up into unreasonably much geometry.
DrawnMeshes read_meshes(const Document& document, const NodeTree& nodes, const ShapeStore& shapes,
                        Warnings& warnings);

} // namespace lambent::scene
