#include "scene/gltf_primitive.h"

#include "scene/gltf_accessor.h"
#include "scene/gltf_deform.h"
#include "scene/gltf_losses.h"
#include "scene/gltf_mend.h"
#include "scene/normals.h"
#include "scene/tangents.h"

#include <glm/common.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

namespace lambent::scene {
namespace {

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

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

// The corners, and the number among them that is none.
struct Corners {
    std::vector<std::uint32_t> list;
    std::uint32_t restart = std::numeric_limits<std::uint32_t>::max();
};

Corners corner_list(const Document& document, const PrimitivePart& part, std::size_t vertices)
{
    Corners corners;
    if (part.primitive.indices < 0) {
        corners.list.resize(vertices);
        for (std::size_t i = 0; i < vertices; ++i)
            corners.list[i] = static_cast<std::uint32_t>(i);
        return corners;
    }
    corners.list = read_indices(document, {part.primitive.indices, part.name + ", indices", false, {}});
    corners.restart = restart_index(document.model.accessors[at(part.primitive.indices)].componentType);
    std::uint32_t largest = 0;
    for (const std::uint32_t corner : corners.list)
        largest = std::max(largest, corner == corners.restart ? 0 : corner);
    if (!corners.list.empty() && largest >= vertices)
        document.fail(part.name, ": index ", largest, " is past its ", vertices, " vertices");
    return corners;
}

// Strips and fans by the formulas of the specification; what they repeat to turn a corner is left out.
// [glTF 2.0, 3.7.2.1]
std::vector<glm::uvec3> triangles_of(std::span<const std::uint32_t> corners, int mode)
{
    std::vector<glm::uvec3> triangles;
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        triangles.resize(corners.size() / 3);
        if (!triangles.empty())
            std::memcpy(triangles.data(), corners.data(), triangles.size() * sizeof(glm::uvec3));
        return triangles;
    }
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        const glm::uvec3 triangle =
            mode == TINYGLTF_MODE_TRIANGLE_STRIP
                ? glm::uvec3(corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2])
                : glm::uvec3(corners[i + 1], corners[i + 2], corners[0]);
        if (triangle.x != triangle.y && triangle.y != triangle.z && triangle.z != triangle.x)
            triangles.push_back(triangle);
    }
    return triangles;
}

std::size_t left_over(std::size_t corners, int mode)
{
    if (mode == TINYGLTF_MODE_TRIANGLES)
        return corners % 3;
    return corners < 3 ? corners : 0;
}

std::vector<glm::uvec3> triangles_between(const Corners& corners, int mode, PrimitiveNotes& notes)
{
    const auto runs = runs_between(corners.list, corners.restart);
    if (runs.size() == 1 && runs.front().size() == corners.list.size()) {
        notes.left_over_indices = left_over(corners.list.size(), mode);
        return triangles_of(corners.list, mode);
    }
    std::vector<glm::uvec3> triangles;
    notes.restarts = corners.list.size();
    for (const std::span<const std::uint32_t> run : runs) {
        const std::vector<glm::uvec3> more = triangles_of(run, mode);
        triangles.insert(triangles.end(), more.begin(), more.end());
        notes.restarts -= run.size();
    }
    return triangles;
}

// Many primitives may share one large set of vertices: each reads only those it uses.
std::vector<std::uint32_t> choose_vertices(std::vector<glm::uvec3>& triangles, std::size_t vertices)
{
    if (triangles.size() * 3 >= vertices)
        return {};
    std::vector<std::uint32_t> used;
    used.reserve(triangles.size() * 3);
    for (const glm::uvec3 triangle : triangles)
        used.insert(used.end(), {triangle.x, triangle.y, triangle.z});
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (glm::uvec3& triangle : triangles)
        for (int corner = 0; corner < 3; ++corner)
            triangle[corner] = static_cast<std::uint32_t>(
                std::lower_bound(used.begin(), used.end(), triangle[corner]) - used.begin());
    return used;
}

// What is faulty, but for the positions, is left out: normals and tangents are made anew then.
void read_attributes(const Document& document, const PrimitivePart& part, std::size_t vertices,
                     Losses& losses, Mesh& mesh)
{
    mesh.positions = read_vec3(document, *attribute(part, "POSITION"));
    const auto read = [&](const char* name, auto&& into) {
        losses.spare("left out", [&] {
            if (auto use = vertex_attribute(document, part, name, vertices))
                into(*use);
        });
    };
    // Whole numbers in unit vectors are fractions even where a file forgets to say so; lengths come later.
    read("NORMAL", [&](AccessorUse& use) {
        use.normalized = true;
        mesh.normals = read_vec3(document, use);
    });
    if (!mesh.normals.empty())
        read("TANGENT", [&](AccessorUse& use) {
            use.normalized = true;
            mesh.tangents = read_vec4(document, use);
        });
    read("TEXCOORD_0", [&](const AccessorUse& use) { mesh.texcoords[0] = read_vec2(document, use); });
    read("TEXCOORD_1", [&](const AccessorUse& use) { mesh.texcoords[1] = read_vec2(document, use); });
    read("COLOR_0", [&](AccessorUse& use) {
        use.normalized = true;
        mesh.colors = read_color(document, use);
    });
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

// Returns the largest coordinate, sign aside. Throws where no triangle has finite ones.
float check_positions(const Document& document, const PrimitivePart& part, Mesh& mesh, PrimitiveNotes& notes)
{
    glm::vec3 reach(0.0f);
    const auto broken = std::find_if(mesh.positions.begin(), mesh.positions.end(),
                                     [](const glm::vec3& position) { return !is_finite(position); });
    if (broken != mesh.positions.end()) {
        const auto vertex = static_cast<std::size_t>(broken - mesh.positions.begin());
        notes.broken_triangles = remove_broken_triangles(mesh);
        if (mesh.triangles.empty())
            document.fail(part.name, ": the position of vertex ",
                          part.selection.empty() ? vertex : part.selection[vertex], " is not finite");
    }
    for (const glm::vec3& position : mesh.positions)
        reach = glm::max(reach, glm::abs(position));
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

// Normals and tangents last: morph targets and skins move what they are made from.
void complete(const TextureNeeds& needs, Mesh& mesh, PrimitiveNotes& notes)
{
    notes.replaced_texcoords +=
        replace_not_finite(mesh.texcoords[0], 0.0f) + replace_not_finite(mesh.texcoords[1], 0.0f);
    notes.replaced_colors += replace_not_finite(mesh.colors, 1.0f);
    notes.clamped_colors += clamp_colors(mesh.colors);
    if (mesh.normals.empty())
        make_flat_normals(mesh);
    else
        notes.rebuilt_normals += repair_normals(mesh);
    notes.rebuilt_tangents += repair_tangents(mesh);
    for (int set = 0; set < 2; ++set)
        notes.missing_texcoords += needs.texcoord[set] && mesh.texcoords[set].empty() ? 1 : 0;
    if (needs.normal_map_set >= 0 && mesh.tangents.empty() && !mesh.texcoords[needs.normal_map_set].empty())
        make_tangents(mesh, needs.normal_map_set, needs.normal_map_transform);
}

// Attributes that nothing reads may be of any kind.
bool is_read(const std::string& attribute)
{
    return attribute == "POSITION" || attribute == "NORMAL" || attribute == "TANGENT" ||
           attribute == "COLOR_0" || attribute == "TEXCOORD_0" || attribute == "TEXCOORD_1" ||
           attribute.starts_with("JOINTS_") || attribute.starts_with("WEIGHTS_");
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
    clamped_colors += other.clamped_colors;
    restarts += other.restarts;
    broken_triangles += other.broken_triangles;
    return *this;
}

bool is_drawable(const Document& document, int mesh, int primitive)
{
    const tinygltf::Primitive& source = find_primitive(document, mesh, primitive);
    if (source.mode < TINYGLTF_MODE_POINTS || source.mode > TINYGLTF_MODE_TRIANGLE_FAN)
        document.fail(primitive_name(mesh, primitive), ": mode ", source.mode, " is not one of glTF");
    return source.mode >= TINYGLTF_MODE_TRIANGLES && source.attributes.contains("POSITION");
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
    // What is faulty here is left out when it is read, and told of then.
    const auto check_if_whole = [&](int accessor, const std::string& what) {
        try {
            check(accessor, what);
        } catch (const Error&) {
        }
    };
    const int position = primitive.attributes.at("POSITION");
    accessor_count(document, {position, name + ", POSITION", false, {}});
    const tinygltf::Accessor& positions = document.model.accessors[at(position)];
    if (positions.bufferView < 0 && !positions.sparse.isSparse &&
        primitive.extensions.contains("KHR_draco_mesh_compression"))
        document.fail(name, ": its geometry is only there as KHR_draco_mesh_compression, which is not read");
    std::uint64_t visits = check(position, "POSITION");
    if (primitive.indices >= 0)
        visits = check(primitive.indices, "indices");
    for (const auto& [attribute_name, accessor] : primitive.attributes)
        if (is_read(attribute_name))
            check_if_whole(accessor, attribute_name);
    std::uint64_t passes = 1;
    for (std::size_t target = 0; target < primitive.targets.size(); ++target) {
        if (target >= request.weights.size() || request.weights[target] == 0.0)
            continue;
        ++passes;
        for (const auto& [attribute_name, accessor] : primitive.targets[target])
            if (is_read(attribute_name))
                check_if_whole(accessor, text("target ", target, " ", attribute_name));
    }
    return visits * passes + sparse;
}

namespace {

void read(const Document& document, const PrimitiveRequest& request, Losses& losses, PrimitiveResult& result)
{
    const tinygltf::Primitive& primitive = find_primitive(document, request.mesh, request.primitive);
    PrimitivePart part{primitive, primitive_name(request.mesh, request.primitive), {}};
    const std::size_t vertices = accessor_count(document, *attribute(part, "POSITION"));

    Mesh& mesh = result.mesh;
    mesh.triangles = triangles_between(corner_list(document, part, vertices), primitive.mode, result.notes);
    if (mesh.triangles.empty())
        return;
    const std::vector<std::uint32_t> selection = choose_vertices(mesh.triangles, vertices);
    part.selection = selection;
    read_attributes(document, part, vertices, losses, mesh);
    result.notes.left_out_displacements = apply_morph_targets(document, part, request.weights, losses, mesh);
    if (!request.skin.empty() && has_skin_attributes(primitive))
        result.in_world =
            losses.spare("drawn without the skin", [&] { apply_skin(document, part, request.skin, mesh); });
    result.reach = check_positions(document, part, mesh, result.notes);
    complete(request.needs, mesh, result.notes);
}

} // namespace

PrimitiveResult read_primitive(const Document& document, const PrimitiveRequest& request)
{
    PrimitiveResult result;
    try {
        Losses losses(document.file, result.faults);
        read(document, request, losses, result);
        return result;
    } catch (const Error& error) {
        return lost_primitive(error);
    }
}

PrimitiveResult lost_primitive(const Error& error)
{
    PrimitiveResult result;
    result.is_lost = true;
    result.loss = error.what();
    return result;
}

} // namespace lambent::scene
