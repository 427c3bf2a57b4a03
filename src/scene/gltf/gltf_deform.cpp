#include "scene/gltf/gltf_deform.h"

#include "scene/gltf/gltf_accessor.h"
#include "scene/index.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lambent::scene {
namespace {

constexpr int most_joint_sets = 4;

AccessorUse use_of(const PrimitivePart& part, int accessor, const std::string& attribute)
{
    return {accessor, part.name + ", " + attribute, false, part.selection};
}

void check_count(const Document& document, const AccessorUse& use, const PrimitivePart& part)
{
    const std::size_t vertices = document.model.accessors[at(part.primitive.attributes.at("POSITION"))].count;
    const std::size_t count = accessor_count(document, use);
    if (count != vertices)
        document.fail(use.what, " has ", count, " elements, POSITION has ", vertices);
}

// Displaces vectors of three components, or the first three components of four.
template <class Vector>
void add_displacement(const Document& document, const PrimitivePart& part, const AccessorUse& use,
                      float weight, std::vector<Vector>& vectors)
{
    check_count(document, use, part);
    const std::vector<glm::vec3> displacement = read_vec3(document, use);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            vectors[i][axis] += weight * displacement[i][axis];
}

// The joints and weights of one set of four.
struct Influences {
    std::vector<glm::u16vec4> joints;
    std::vector<glm::vec4> weights;
};

std::vector<Influences> read_influences(const Document& document, const PrimitivePart& part)
{
    std::vector<Influences> sets;
    for (int set = 0; set < most_joint_sets; ++set) {
        const auto joints = part.primitive.attributes.find(text("JOINTS_", set));
        const auto weights = part.primitive.attributes.find(text("WEIGHTS_", set));
        if (joints == part.primitive.attributes.end() || weights == part.primitive.attributes.end())
            break;
        const AccessorUse joint_use = use_of(part, joints->second, joints->first);
        AccessorUse weight_use = use_of(part, weights->second, weights->first);
        weight_use.normalized = true;
        check_count(document, joint_use, part);
        check_count(document, weight_use, part);
        sets.push_back({read_joints(document, joint_use), read_vec4(document, weight_use)});
    }
    return sets;
}

glm::mat4 blend(const std::vector<Influences>& sets, std::size_t vertex, std::span<const glm::mat4> matrices)
{
    glm::mat4 sum(0.0f);
    float total = 0.0f;
    for (const Influences& set : sets) {
        for (int i = 0; i < 4; ++i) {
            const float weight = set.weights[vertex][i];
            if (weight == 0.0f)
                continue;
            sum += matrices[set.joints[vertex][i]] * weight;
            total += weight;
        }
    }
    return total > 0.0f ? sum / total : matrices[sets.front().joints[vertex].x];
}

void check_joints(const Document& document, const PrimitivePart& part, const std::vector<Influences>& sets,
                  std::size_t joints)
{
    for (const Influences& set : sets)
        for (std::size_t vertex = 0; vertex < set.joints.size(); ++vertex)
            for (int i = 0; i < 4; ++i) {
                if (set.joints[vertex][i] >= joints)
                    document.fail(part.name, ": joint ", set.joints[vertex][i], " is past the skin's ",
                                  joints, " joints");
                if (!std::isfinite(set.weights[vertex][i]))
                    document.fail(part.name, ": a joint's weight is not finite");
            }
}

bool is_finite(const glm::mat4& matrix)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row]))
                return false;
    return true;
}

// The matrix of cofactors. With the sign of the determinant it transforms normals, like the inverse transpose.
glm::mat3 cofactors(const glm::mat3& m)
{
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

void move_vertex(Mesh& mesh, std::size_t vertex, const glm::mat4& matrix, bool mirrored)
{
    const glm::mat3 linear(matrix);
    mesh.positions[vertex] = glm::vec3(matrix * glm::vec4(mesh.positions[vertex], 1.0f));
    if (!mesh.normals.empty())
        mesh.normals[vertex] = cofactors(linear) * mesh.normals[vertex] * (mirrored ? -1.0f : 1.0f);
    if (!mesh.tangents.empty()) {
        glm::vec4& tangent = mesh.tangents[vertex];
        tangent = glm::vec4(linear * glm::vec3(tangent), mirrored ? -tangent.w : tangent.w);
    }
}

} // namespace

std::size_t apply_morph_targets(const Document& document, const PrimitivePart& part,
                                std::span<const double> weights, Losses& losses, Mesh& mesh)
{
    const auto& targets = part.primitive.targets;
    std::size_t left_out = 0;
    for (std::size_t target = 0; target < std::min(targets.size(), weights.size()); ++target) {
        const auto weight = static_cast<float>(weights[target]);
        if (weight == 0.0f)
            continue;
        for (const auto& [attribute, accessor] : targets[target]) {
            const AccessorUse use =
                use_of(part, accessor, text("target ", target, " ", printable(attribute)));
            losses.spare("left out", [&, &attribute = attribute] {
                if (attribute == "POSITION")
                    add_displacement(document, part, use, weight, mesh.positions);
                else if (attribute == "NORMAL" && !mesh.normals.empty())
                    add_displacement(document, part, use, weight, mesh.normals);
                else if (attribute == "TANGENT" && !mesh.tangents.empty())
                    add_displacement(document, part, use, weight, mesh.tangents);
                else if (attribute.starts_with("TEXCOORD_") || attribute.starts_with("COLOR_"))
                    ++left_out;
            });
        }
    }
    return left_out;
}

std::vector<glm::mat4> skin_matrices(const Document& document, const NodeTree& nodes, int skin)
{
    if (skin < 0 || at(skin) >= document.model.skins.size())
        document.fail("skin ", skin, " does not exist");
    const gltf::Skin& source = document.model.skins[at(skin)];
    if (source.is_broken)
        throw told_already();
    std::vector<glm::mat4> inverse_bind;
    if (source.inverse_bind_matrices >= 0 && !source.joints.empty()) {
        AccessorUse use{
            source.inverse_bind_matrices, text("skin ", skin, ", inverseBindMatrices"), false, {}};
        if (const std::size_t count = accessor_count(document, use); count < source.joints.size())
            document.fail("skin ", skin, ": ", count, " inverse bind matrices for ", source.joints.size(),
                          " joints");
        std::vector<std::uint32_t> one_each(source.joints.size());
        std::iota(one_each.begin(), one_each.end(), 0u);
        use.selection = one_each;
        inverse_bind = read_mat4(document, use);
        for (std::size_t joint = 0; joint < inverse_bind.size(); ++joint)
            if (!is_finite(inverse_bind[joint]))
                document.fail("skin ", skin, ": inverse bind matrix ", joint, " is not finite");
    }
    std::vector<glm::mat4> matrices;
    for (std::size_t joint = 0; joint < source.joints.size(); ++joint) {
        const int node = source.joints[joint];
        if (node == gltf::unreadable_index)
            throw told_already();
        if (node < 0 || at(node) >= nodes.world.size())
            document.fail("skin ", skin, ": joint node ", node, " does not exist");
        const glm::dmat4 bind = inverse_bind.empty() ? glm::dmat4(1.0) : glm::dmat4(inverse_bind[joint]);
        matrices.push_back(glm::mat4(nodes.world[at(node)] * bind));
    }
    return matrices;
}

bool has_skin_attributes(const gltf::Primitive& primitive)
{
    return primitive.attributes.contains("JOINTS_0") && primitive.attributes.contains("WEIGHTS_0");
}

void apply_skin(const Document& document, const PrimitivePart& part, std::span<const glm::mat4> matrices,
                Mesh& mesh)
{
    const std::vector<Influences> sets = read_influences(document, part);
    check_joints(document, part, sets, matrices.size());
    std::vector<bool> mirrored(mesh.positions.size());
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        const glm::mat4 matrix = blend(sets, vertex, matrices);
        mirrored[vertex] = glm::determinant(glm::mat3(matrix)) < 0.0f;
        move_vertex(mesh, vertex, matrix, mirrored[vertex]);
    }
    for (glm::uvec3& triangle : mesh.triangles)
        if (mirrored[triangle.x])
            std::swap(triangle.y, triangle.z);
}

} // namespace lambent::scene
