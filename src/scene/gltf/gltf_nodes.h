// The node hierarchy, flattened.
#pragma once

#include "scene/gltf_document/gltf_document.h"

#include <glm/ext/matrix_double4x4.hpp>
#include <glm/ext/quaternion_double.hpp>
#include <glm/ext/vector_double3.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lambent::scene {

/// Properties of a node at a moment, in place of the file's. Those that are unset stay as in the file.
struct NodePose {
    std::optional<glm::dvec3> translation;
    std::optional<glm::dquat> rotation; ///< unit length
    std::optional<glm::dvec3> scale;
    bool morphs = false;         ///< whether its morph weights are animated
    std::vector<double> weights; ///< the morph weights, if animated
};

/// The poses of nodes that any animation moves, by index. Empty: no animation moves any.
using Pose = std::map<int, NodePose>;

struct NodeTree {
    std::vector<glm::dmat4> world; ///< of every node of the file: world from node; finite, affine
    glm::dvec3 origin{0.0};        ///< the point of the world that positions are relative to
    std::vector<int> drawn;        ///< nodes of the scene, parents before children, in the order of the file
    std::vector<bool> hidden;      ///< of every node of the file: its meshes and lights are not shown
    Pose pose;                     ///< the pose that the transforms are for
    std::string first_loss;        ///< message of the first fault that may have cost geometry; empty: none
};

/// Computes world transforms without recursion. The drawn scene is the default one, else the first, else (in a file
/// without scenes) all roots. Faulty links are removed with a warning: to children and roots that do not exist, to a
/// second parent, and the link that closes a cycle. The transform of a root that has a parent includes the parent's. A
/// matrix that is not affine loses its last row, a rotation without length is ignored, and a node whose world
/// transform is not finite is flattened to a point. Rotations that are not of unit length are normalised, with one
/// warning.
NodeTree build_node_tree(const Document& document, Pose pose, Warnings& warnings);

/// Makes all world transforms relative to a point of the world.
void move_origin(NodeTree& nodes, const glm::dvec3& origin);

} // namespace lambent::scene
