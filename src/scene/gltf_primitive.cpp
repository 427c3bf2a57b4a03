#include "scene/gltf_primitive.h"

#include "scene/gltf_accessor.h"
#include "scene/gltf_deform.h"
#include "scene/gltf_topology.h"
#include "scene/index.h"
#include "scene/normals.h"
#include "scene/tangents.h"

#include <glm/common.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>

namespace lambent::scene {
namespace {

const tinygltf::Primitive& find_primitive(const Document& document, int mesh, int primitive)
{
    return document.model.meshes[at(mesh)].primitives[at(primitive)];
}

std::string primitive_name(int mesh, int primitive)
{
    return text("mesh ", mesh, ", primitive ", primitive);
}

// The attribute's accessor, if the primitive has it.
std::optional<AccessorUse> attribute(const PrimitivePart& part, const char* name)
{
    const auto found = part.primitive.attributes.find(name);
    if (found == part.primitive.attributes.end())
        return std::nullopt;
    return AccessorUse{found->second, part.name + ", " + name, false, part.selection};
}

// As above, having checked that it is as long as the positions.
std::optional<AccessorUse> vertex_attribute(const Document& document, const PrimitivePart& part,
                                            const char* name, std::size_t vertices)
{
    auto use = attribute(part, name);
    if (use && accessor_count(document, *use) != vertices)
        document.fail(use->what, " has ", accessor_count(document, *use), " elements, POSITION has ",
                      vertices);
    return use;
}

std::vector<std::uint32_t> corner_list(const Document& document, const PrimitivePart& part,
                                       std::size_t vertices)
{
    std::vector<std::uint32_t> corners;
    if (part.primitive.indices < 0) {
        corners.resize(vertices);
        for (std::size_t i = 0; i < vertices; ++i)
            corners[i] = static_cast<std::uint32_t>(i);
        return corners;
    }
    corners = read_indices(document, {part.primitive.indices, part.name + ", indices", false, {}});
    std::uint32_t largest = 0;
    for (const std::uint32_t corner : corners)
        largest = std::max(largest, corner);
    if (!corners.empty() && largest >= vertices)
        document.fail(part.name, ": index ", largest, " is past its ", vertices, " vertices");
    return corners;
}

// The sets that the material asks for, and the two that every program reads.
std::set<int> texcoord_sets(const TextureNeeds& needs)
{
    std::set<int> sets = needs.texcoords;
    sets.insert({0, 1});
    return sets;
}

void read_attributes(const Document& document, const PrimitivePart& part, const TextureNeeds& needs,
                     std::size_t vertices, Mesh& mesh)
{
    mesh.positions = read_vec3(document, *attribute(part, "POSITION"));
    // Whole numbers in unit vectors are fractions even where a file forgets to say so; lengths come later.
    if (auto use = vertex_attribute(document, part, "NORMAL", vertices)) {
        use->normalized = true;
        mesh.normals = read_vec3(document, *use);
    }
    if (auto use = vertex_attribute(document, part, "TANGENT", vertices); use && !mesh.normals.empty()) {
        use->normalized = true;
        mesh.tangents = read_vec4(document, *use);
    }
    for (const int set : texcoord_sets(needs))
        if (const auto use = vertex_attribute(document, part, text("TEXCOORD_", set).c_str(), vertices))
            mesh.texcoords[set] = read_vec2(document, *use);
    if (auto use = vertex_attribute(document, part, "COLOR_0", vertices)) {
        use->normalized = true;
        mesh.colors = read_color(document, *use);
    }
}

bool is_finite(float value)
{
    return (std::bit_cast<std::uint32_t>(value) & 0x7F800000u) != 0x7F800000u;
}

template <class Vector>
bool is_finite(const Vector& vector)
{
    for (int i = 0; i < Vector::length(); ++i)
        if (!is_finite(vector[i]))
            return false;
    return true;
}

// Returns the largest coordinate, sign aside.
float check_positions(const Document& document, const PrimitivePart& part, const Mesh& mesh)
{
    glm::vec3 reach(0.0f);
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        if (!is_finite(mesh.positions[vertex]))
            document.fail(part.name, ": the position of vertex ",
                          part.selection.empty() ? vertex : part.selection[vertex], " is not finite");
        reach = glm::max(reach, glm::abs(mesh.positions[vertex]));
    }
    return std::max({reach.x, reach.y, reach.z});
}

template <class Vector>
std::size_t replace_not_finite(std::vector<Vector>& vectors, float replacement)
{
    std::size_t count = 0;
    for (Vector& vector : vectors) {
        if (is_finite(vector))
            continue;
        vector = Vector(replacement);
        ++count;
    }
    return count;
}

// Lines without normals keep none, and lines without tangents go without normal maps. [glTF 2.0, 3.9.6]
void complete_triangles(const TextureNeeds& needs, Mesh& mesh, PrimitiveNotes& notes)
{
    if (mesh.normals.empty())
        make_flat_normals(mesh);
    else
        notes.rebuilt_normals += repair_normals(mesh);
    notes.rebuilt_tangents += repair_tangents(mesh);
    const int set = needs.normal_map_set;
    if (set >= 0 && mesh.tangents.empty() && !std::as_const(mesh).texcoords[set].empty())
        make_tangents(mesh, set, needs.normal_map_transform);
}

// Normals and tangents last: morph targets and skins move what they are made from.
void complete(const TextureNeeds& needs, Mesh& mesh, PrimitiveNotes& notes)
{
    for (auto& [number, set] : mesh.texcoords)
        notes.replaced_texcoords += replace_not_finite(set, 0.0f);
    notes.replaced_colors += replace_not_finite(mesh.colors, 1.0f);
    for (const int set : needs.texcoords)
        notes.missing_texcoords += std::as_const(mesh).texcoords[set].empty() ? 1 : 0;
    if (!has_lines(mesh)) {
        complete_triangles(needs, mesh, notes);
    } else if (!mesh.normals.empty()) {
        notes.rebuilt_normals += repair_normals(mesh);
        notes.rebuilt_tangents += repair_tangents(mesh);
    }
}

// Attributes that nothing reads may be of any kind.
bool is_read(const std::string& attribute, const TextureNeeds& needs)
{
    if (attribute == "POSITION" || attribute == "NORMAL" || attribute == "TANGENT" ||
        attribute == "COLOR_0" || attribute.starts_with("JOINTS_") || attribute.starts_with("WEIGHTS_"))
        return true;
    const std::set<int> sets = texcoord_sets(needs);
    return std::any_of(sets.begin(), sets.end(),
                       [&](int set) { return attribute == text("TEXCOORD_", set); });
}

} // namespace

PrimitiveNotes& PrimitiveNotes::operator+=(const PrimitiveNotes& other)
{
    rebuilt_normals += other.rebuilt_normals;
    rebuilt_tangents += other.rebuilt_tangents;
    replaced_texcoords += other.replaced_texcoords;
    replaced_colors += other.replaced_colors;
    left_over_indices += other.left_over_indices;
    missing_texcoords += other.missing_texcoords;
    left_out_displacements += other.left_out_displacements;
    return *this;
}

bool is_drawable(const Document& document, int mesh, int primitive)
{
    const tinygltf::Primitive& source = find_primitive(document, mesh, primitive);
    if (source.mode < TINYGLTF_MODE_POINTS || source.mode > TINYGLTF_MODE_TRIANGLE_FAN)
        document.fail(primitive_name(mesh, primitive), ": mode ", source.mode, " is not one of glTF");
    return source.attributes.contains("POSITION");
}

std::uint64_t check_request(const Document& document, const PrimitiveRequest& request)
{
    const tinygltf::Primitive& primitive = find_primitive(document, request.mesh, request.primitive);
    const std::string name = primitive_name(request.mesh, request.primitive);
    std::uint64_t sparse = 0;
    const auto check = [&](int accessor, const std::string& what) {
        const AccessorUse use{accessor, name + ", " + what, false, {}};
        check_accessor(document, use);
        sparse += sparse_count(document, accessor);
        return static_cast<std::uint64_t>(accessor_count(document, use));
    };
    const int position = primitive.attributes.at("POSITION");
    accessor_count(document, {position, name + ", POSITION", false, {}});
    if (document.model.accessors[at(position)].bufferView < 0 &&
        primitive.extensions.contains("KHR_draco_mesh_compression"))
        document.fail(name, ": its geometry is only there as KHR_draco_mesh_compression");
    std::uint64_t visits = check(position, "POSITION");
    if (primitive.indices >= 0)
        visits = check(primitive.indices, "indices");
    for (const auto& [attribute_name, accessor] : primitive.attributes)
        if (is_read(attribute_name, request.needs))
            check(accessor, attribute_name);
    std::uint64_t passes = 1;
    for (std::size_t target = 0; target < primitive.targets.size(); ++target) {
        if (target >= request.weights.size() || request.weights[target] == 0.0)
            continue;
        ++passes;
        for (const auto& [attribute_name, accessor] : primitive.targets[target])
            if (is_read(attribute_name, request.needs))
                check(accessor, text("target ", target, " ", attribute_name));
    }
    return visits * passes + sparse;
}

PrimitiveResult read_primitive(const Document& document, const PrimitiveRequest& request)
{
    const tinygltf::Primitive& primitive = find_primitive(document, request.mesh, request.primitive);
    PrimitivePart part{primitive, primitive_name(request.mesh, request.primitive), {}};
    const std::size_t vertices = accessor_count(document, *attribute(part, "POSITION"));

    PrimitiveResult result;
    Mesh& mesh = result.mesh;
    {
        const std::vector<std::uint32_t> corners = corner_list(document, part, vertices);
        result.notes.left_over_indices = connect(corners, primitive.mode, mesh);
    }
    if (is_empty(mesh))
        return result;
    const std::vector<std::uint32_t> selection = choose_vertices(mesh, vertices);
    part.selection = selection;
    read_attributes(document, part, request.needs, vertices, mesh);
    result.notes.left_out_displacements = apply_morph_targets(document, part, request.weights, mesh);
    if (!request.skin.empty() && has_skin_attributes(primitive)) {
        apply_skin(document, part, request.skin, mesh);
        result.in_world = true;
    }
    result.reach = check_positions(document, part, mesh);
    complete(request.needs, mesh, result.notes);
    return result;
}

} // namespace lambent::scene
