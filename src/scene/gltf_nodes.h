// The node hierarchy, flattened.
#pragma once

#include "scene/gltf_document.h"

#include <glm/ext/matrix_double4x4.hpp>

#include <vector>

namespace lambent::scene {

struct NodeTree {
    std::vector<glm::dmat4> world; ///< of every node of the file: world from node; finite, affine
    std::vector<int> drawn;        ///< nodes of the scene, parents before children, in the order of the file
};

/// Works out world transforms without recursion. The drawn scene is the default one, else the first, else
/// (a file without scenes) all roots.
/// Throws Error(bad_input) for indices that do not exist, a node with two parents or in a cycle, a scene that
/// lists a node that is not a root, a matrix that is not affine, a rotation of length zero.
/// Rotations that are not of unit length are normalised, with one warning.
NodeTree build_node_tree(const Document& document, Warnings& warnings);

} // namespace lambent::scene
