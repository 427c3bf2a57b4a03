#include "scene/gltf/gltf_nodes.h"

#include "scene/gltf_document/gltf_losses.h"
#include "scene/index.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/ext/quaternion_double.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace lambent::scene {
namespace {

constexpr int no_parent = -1;

// Reports faults in the hierarchy.
class HierarchyFaults {
public:
    HierarchyFaults(const Document& document, Warnings& warnings)
        : file_(document.file), losses_(document.file, warnings)
    {
    }

    template <class... Parts>
    void add(const char* cost, const Parts&... parts)
    {
        losses_.add(text(file_, ": ", parts...), cost);
    }

    // A fault that may cost geometry.
    template <class... Parts>
    void lose(const char* cost, const Parts&... parts)
    {
        add(cost, parts...);
        if (first_.empty())
            first_ = text(file_, ": ", parts...);
    }

    const std::string& first() const { return first_; }

private:
    const std::string& file_;
    Losses losses_;
    std::string first_;
};

// The file's nodes as a forest: each has one parent at most, and none is its own ancestor.
struct Forest {
    std::vector<int> parents;
    std::vector<std::vector<int>> children;
};

Forest find_links(const Document& document, HierarchyFaults& faults)
{
    const auto& nodes = document.model.nodes;
    Forest forest{std::vector<int>(nodes.size(), no_parent), std::vector<std::vector<int>>(nodes.size())};
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        for (const int child : nodes[node].children) {
            if (child == gltf::unreadable_index)
                continue;
            if (child < 0 || at(child) >= nodes.size()) {
                faults.lose("left out", "node ", node, ": child ", child, " does not exist");
            } else if (forest.parents[at(child)] != no_parent) {
                faults.lose("the first one is kept", "node ", child, " has two parents, ",
                            forest.parents[at(child)], " and ", node);
            } else {
                forest.parents[at(child)] = static_cast<int>(node);
                forest.children[node].push_back(child);
            }
        }
    }
    return forest;
}

glm::dmat4 matrix_transform(const Document& document, std::size_t node, HierarchyFaults& faults)
{
    const std::vector<double>& values = document.model.nodes[node].matrix;
    glm::dmat4 matrix;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            matrix[column][row] = values[static_cast<std::size_t>(column * 4 + row)];
    constexpr double slack = 1e-6; // rounding errors of exporters
    if (std::abs(matrix[0][3]) > slack || std::abs(matrix[1][3]) > slack || std::abs(matrix[2][3]) > slack ||
        std::abs(matrix[3][3] - 1.0) > slack)
        faults.add("its last row is ignored", "node ", node, ": its matrix is not affine");
    matrix[0][3] = matrix[1][3] = matrix[2][3] = 0.0;
    matrix[3][3] = 1.0;
    return matrix;
}

struct LocalTransform {
    glm::dmat4 matrix{1.0};
    bool rotation_was_unit = true;
};

LocalTransform local_transform(const Document& document, std::size_t index, const NodePose& pose,
                               HierarchyFaults& faults)
{
    const gltf::Node& node = document.model.nodes[index];
    LocalTransform local;
    if (!node.matrix.empty()) {
        local.matrix = matrix_transform(document, index, faults);
        return local;
    }
    if (pose.translation)
        local.matrix[3] = glm::dvec4(*pose.translation, 1.0);
    else if (const auto& translation = node.translation)
        local.matrix[3] = {(*translation)[0], (*translation)[1], (*translation)[2], 1.0};
    if (pose.rotation) {
        local.matrix *= glm::mat4_cast(*pose.rotation);
    } else if (const auto& rotation = node.rotation) {
        const glm::dquat quaternion((*rotation)[3], (*rotation)[0], (*rotation)[1], (*rotation)[2]);
        const double length = glm::length(quaternion);
        if (length > 1e-30 && std::isfinite(length)) {
            local.rotation_was_unit = std::abs(length - 1.0) < 1e-2;
            local.matrix *= glm::mat4_cast(quaternion / length);
        } else {
            faults.add("ignored", "node ", index, ": its rotation has no length");
        }
    }
    if (pose.scale)
        local.matrix = glm::scale(local.matrix, *pose.scale);
    else if (const auto& scale = node.scale)
        local.matrix = glm::scale(local.matrix, glm::dvec3((*scale)[0], (*scale)[1], (*scale)[2]));
    return local;
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

std::vector<int> scene_roots(const Document& document, const std::vector<int>& parents,
                             HierarchyFaults& faults)
{
    const auto& model = document.model;
    int scene = std::max(model.scene, 0);
    if (at(scene) >= model.scenes.size() && model.scene >= 0) {
        faults.add("ignored", "scene ", scene, " does not exist");
        scene = 0;
    }
    if (model.scenes.empty())
        return all_roots(parents);
    std::vector<bool> listed(parents.size(), false);
    std::vector<int> roots;
    for (const int root : model.scenes[at(scene)].nodes) {
        if (root == gltf::unreadable_index)
            continue;
        if (root < 0 || at(root) >= parents.size()) {
            faults.lose("left out", "scene ", scene, ": node ", root, " does not exist");
            continue;
        }
        if (listed[at(root)]) {
            faults.add("drawn once", "scene ", scene, ": node ", root, " is listed twice");
            continue;
        }
        if (parents[at(root)] != no_parent)
            faults.add("the parent's transform applies", "scene ", scene, ": root node ", root,
                       " has a parent, node ", parents[at(root)]);
        listed[at(root)] = true;
        roots.push_back(root);
    }
    return roots;
}

// Nodes reachable from the roots, parents first, each subtree in the order of the file, each once.
std::vector<int> preorder(const Forest& forest, const std::vector<int>& roots)
{
    std::vector<int> order;
    std::vector<bool> seen(forest.parents.size(), false);
    std::vector<int> waiting(roots.rbegin(), roots.rend());
    while (!waiting.empty()) {
        const int node = waiting.back();
        waiting.pop_back();
        if (seen[at(node)])
            continue;
        seen[at(node)] = true;
        order.push_back(node);
        const std::vector<int>& children = forest.children[at(node)];
        waiting.insert(waiting.end(), children.rbegin(), children.rend());
    }
    return order;
}

// Since each node has at most one parent, nodes that no root reaches are in or below a cycle. One link of each cycle is
// removed.
void cut_cycles(Forest& forest, HierarchyFaults& faults)
{
    std::vector<bool> reached(forest.parents.size(), false);
    for (const int node : preorder(forest, all_roots(forest.parents)))
        reached[at(node)] = true;
    std::vector<bool> passed(reached.size(), false);
    for (std::size_t start = 0; start < reached.size(); ++start) {
        if (reached[start])
            continue;
        auto node = static_cast<int>(start);
        for (; !passed[at(node)]; node = forest.parents[at(node)])
            passed[at(node)] = true;
        faults.lose("cut off from its parent", "node ", node, " is its own ancestor");
        std::erase(forest.children[at(forest.parents[at(node)])], node);
        forest.parents[at(node)] = no_parent;
        for (std::vector<int> waiting = {node}; !waiting.empty();) {
            const int below = waiting.back();
            waiting.pop_back();
            reached[at(below)] = true;
            waiting.insert(waiting.end(), forest.children[at(below)].begin(),
                           forest.children[at(below)].end());
        }
    }
}

} // namespace

NodeTree build_node_tree(const Document& document, Pose pose, Warnings& warnings)
{
    HierarchyFaults faults(document, warnings);
    Forest forest = find_links(document, faults);
    cut_cycles(forest, faults);
    const std::vector<int>& parents = forest.parents;

    NodeTree tree;
    tree.world.resize(parents.size());
    tree.hidden.resize(parents.size());
    const NodePose at_rest;
    std::size_t odd_rotations = 0;
    for (const int node : preorder(forest, all_roots(parents))) {
        const auto posed = pose.find(node);
        const LocalTransform local =
            local_transform(document, at(node), posed == pose.end() ? at_rest : posed->second, faults);
        odd_rotations += local.rotation_was_unit ? 0 : 1;
        const int parent = parents[at(node)];
        glm::dmat4& world = tree.world[at(node)];
        world = parent == no_parent ? local.matrix : tree.world[at(parent)] * local.matrix;
        // Cameras are not affected. [KHR_node_visibility]
        tree.hidden[at(node)] =
            !document.model.nodes[at(node)].visible || (parent != no_parent && tree.hidden[at(parent)]);
        if (fits_floats(world))
            continue;
        faults.lose("left out", "node ", node, ": its transform in the world is not finite");
        world = glm::scale(glm::dmat4(1.0), glm::dvec3(0.0)); // a point, like other flattened nodes
    }
    if (odd_rotations != 0)
        warnings.push_back(
            text(document.file, ": ", odd_rotations, " node rotations were not of unit length: normalised"));
    tree.drawn = preorder(forest, scene_roots(document, parents, faults));
    tree.pose = std::move(pose);
    tree.first_loss = faults.first();
    return tree;
}

void move_origin(NodeTree& nodes, const glm::dvec3& origin)
{
    for (glm::dmat4& world : nodes.world)
        world[3] -= glm::dvec4(origin, 0.0);
    nodes.origin += origin;
}

} // namespace lambent::scene
