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

/// What a node has at a moment in place of what the file says; what is unset stays as it is there.
struct NodePose {
    std::optional<glm::dvec3> translation;
    std::optional<glm::dquat> rotation; ///< unit length
    std::optional<glm::dvec3> scale;
    bool morphs = false;         ///< whether its morph targets' weights change from moment to moment
    std::vector<double> weights; ///< where it does: those weights
};

/// Of the nodes that may move, by number. Empty: nothing in the file ever moves.
using Pose = std::map<int, NodePose>;

struct NodeTree {
    std::vector<glm::dmat4> world; ///< of every node of the file: world from node; finite, affine
    glm::dvec3 origin{0.0};        ///< the point of the world that places are relative to
    std::vector<int> drawn;        ///< nodes of the scene, parents before children, in the order of the file
    std::vector<bool> hidden;      ///< of every node of the file: its meshes and lights are not shown
    Pose pose;                     ///< what the transforms were made with
    std::string first_loss;        ///< the first fault that may have cost something to draw; empty: none
};

/// Works out world transforms without recursion. The drawn scene is the default one, else the first, else
/// (a file without scenes) all roots.
/// Faults cost, with a warning, the link that they are about: children and roots that do not exist, a second parent, the
/// link that closes a circle. A root that has a parent is drawn where that puts it. A matrix that is not affine loses its
/// last row, a rotation without length does not turn, and what is not finite in the world is flattened to a point.
/// Rotations that are not of unit length are normalised, with one warning.
NodeTree build_node_tree(const Document& document, Pose pose, Warnings& warnings);

/// Makes all world transforms relative to a point of the world.
void move_origin(NodeTree& nodes, const glm::dvec3& origin);

} // namespace lambent::scene
