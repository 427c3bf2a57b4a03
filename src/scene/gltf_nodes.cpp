#include "scene/gltf_nodes.h"

#include "scene/index.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/ext/quaternion_double.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <cstddef>
#include <limits>

namespace lambent::scene {
namespace {

constexpr int no_parent = -1;

std::vector<int> find_parents(const Document& document)
{
    const auto& nodes = document.model.nodes;
    std::vector<int> parents(nodes.size(), no_parent);
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        for (const int child : nodes[node].children) {
            if (child < 0 || at(child) >= nodes.size())
                document.fail("node ", node, ": child ", child, " does not exist");
            if (parents[at(child)] != no_parent)
                document.fail("node ", child, " has two parents, ", parents[at(child)], " and ", node);
            parents[at(child)] = static_cast<int>(node);
        }
    }
    return parents;
}

glm::dmat4 matrix_transform(const Document& document, std::size_t node)
{
    const std::vector<double>& values = document.model.nodes[node].matrix;
    glm::dmat4 matrix;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            matrix[column][row] = values[static_cast<std::size_t>(column * 4 + row)];
    constexpr double slack = 1e-6; // exporters write what their own inverse left over
    if (std::abs(matrix[0][3]) > slack || std::abs(matrix[1][3]) > slack || std::abs(matrix[2][3]) > slack ||
        std::abs(matrix[3][3] - 1.0) > slack)
        document.fail("node ", node, ": its matrix is not affine");
    matrix[0][3] = matrix[1][3] = matrix[2][3] = 0.0;
    matrix[3][3] = 1.0;
    return matrix;
}

struct LocalTransform {
    glm::dmat4 matrix{1.0};
    bool rotation_was_unit = true;
};

LocalTransform local_transform(const Document& document, std::size_t index, const NodePose& pose)
{
    const tinygltf::Node& node = document.model.nodes[index];
    LocalTransform local;
    if (!node.matrix.empty()) {
        local.matrix = matrix_transform(document, index);
        return local;
    }
    if (pose.translation)
        local.matrix[3] = glm::dvec4(*pose.translation, 1.0);
    else if (!node.translation.empty())
        local.matrix[3] = {node.translation[0], node.translation[1], node.translation[2], 1.0};
    if (pose.rotation) {
        local.matrix *= glm::mat4_cast(*pose.rotation);
    } else if (!node.rotation.empty()) {
        const glm::dquat quaternion(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
        const double length = glm::length(quaternion);
        if (!(length > 1e-30 && std::isfinite(length)))
            document.fail("node ", index, ": its rotation has no length");
        local.rotation_was_unit = std::abs(length - 1.0) < 1e-2;
        local.matrix *= glm::mat4_cast(quaternion / length);
    }
    if (pose.scale)
        local.matrix = glm::scale(local.matrix, *pose.scale);
    else if (!node.scale.empty())
        local.matrix = glm::scale(local.matrix, glm::dvec3(node.scale[0], node.scale[1], node.scale[2]));
    return local;
}

// Cameras are there all the same. [KHR_node_visibility]
bool hides(const tinygltf::Node& node)
{
    const auto extension = node.extensions.find("KHR_node_visibility");
    return extension != node.extensions.end() && extension->second.Has("visible") &&
           !extension->second.Get("visible").Get<bool>();
}

bool fits_floats(const glm::dmat4& matrix)
{
    constexpr double most = std::numeric_limits<float>::max();
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!(std::abs(matrix[column][row]) <= most))
                return false;
    return true;
}

std::vector<int> all_roots(const std::vector<int>& parents)
{
    std::vector<int> roots;
    for (std::size_t node = 0; node < parents.size(); ++node)
        if (parents[node] == no_parent)
            roots.push_back(static_cast<int>(node));
    return roots;
}

std::vector<int> scene_roots(const Document& document, const std::vector<int>& parents)
{
    const auto& model = document.model;
    if (model.scenes.empty() && model.defaultScene < 0)
        return all_roots(parents);
    const int scene = std::max(model.defaultScene, 0);
    if (at(scene) >= model.scenes.size())
        document.fail("scene ", scene, " does not exist");
    std::vector<bool> listed(parents.size(), false);
    const std::vector<int>& roots = model.scenes[at(scene)].nodes;
    for (const int root : roots) {
        if (root < 0 || at(root) >= parents.size())
            document.fail("scene ", scene, ": node ", root, " does not exist");
        if (parents[at(root)] != no_parent)
            document.fail("scene ", scene, ": node ", root, " is no root: node ", parents[at(root)],
                          " is its parent");
        if (listed[at(root)])
            document.fail("scene ", scene, ": node ", root, " is listed twice");
        listed[at(root)] = true;
    }
    return roots;
}

// Nodes reachable from the roots, parents first, each subtree in the order of the file.
std::vector<int> preorder(const Document& document, const std::vector<int>& roots)
{
    std::vector<int> order;
    std::vector<int> waiting(roots.rbegin(), roots.rend());
    while (!waiting.empty()) {
        const int node = waiting.back();
        waiting.pop_back();
        order.push_back(node);
        const std::vector<int>& children = document.model.nodes[at(node)].children;
        waiting.insert(waiting.end(), children.rbegin(), children.rend());
    }
    return order;
}

// With one parent each, nodes that no root reaches go round in circles.
void check_cycles(const Document& document, const std::vector<int>& order, const std::vector<int>& parents)
{
    if (order.size() == parents.size())
        return;
    std::vector<bool> reached(parents.size(), false);
    for (const int node : order)
        reached[at(node)] = true;
    int node = 0;
    while (reached[at(node)])
        ++node;
    // From a node below a cycle the way up leads into it.
    for (std::size_t step = 0; step < parents.size(); ++step)
        node = parents[at(node)];
    document.fail("node ", node, " is its own ancestor");
}

} // namespace

NodeTree build_node_tree(const Document& document, Pose pose, Warnings& warnings)
{
    const std::vector<int> parents = find_parents(document);
    const std::vector<int> order = preorder(document, all_roots(parents));
    check_cycles(document, order, parents);

    NodeTree tree;
    tree.world.resize(parents.size());
    tree.hidden.resize(parents.size());
    const NodePose at_rest;
    std::size_t odd_rotations = 0;
    for (const int node : order) {
        const auto posed = pose.find(node);
        const LocalTransform local =
            local_transform(document, at(node), posed == pose.end() ? at_rest : posed->second);
        odd_rotations += local.rotation_was_unit ? 0 : 1;
        const int parent = parents[at(node)];
        tree.world[at(node)] = parent == no_parent ? local.matrix : tree.world[at(parent)] * local.matrix;
        tree.hidden[at(node)] =
            hides(document.model.nodes[at(node)]) || (parent != no_parent && tree.hidden[at(parent)]);
        if (!fits_floats(tree.world[at(node)]))
            document.fail("node ", node, ": its transform in the world is not finite");
    }
    if (odd_rotations != 0)
        warnings.push_back(
            text(document.file, ": ", odd_rotations, " node rotations were not of unit length: normalised"));
    tree.drawn = preorder(document, scene_roots(document, parents));
    tree.pose = std::move(pose);
    return tree;
}

void move_origin(NodeTree& nodes, const glm::dvec3& origin)
{
    for (glm::dmat4& world : nodes.world)
        world[3] -= glm::dvec4(origin, 0.0);
}

} // namespace lambent::scene
