#include "scene/gltf/gltf_primitive.h"

#include "scene/gltf/gltf_accessor.h"
#include "scene/gltf/gltf_attributes.h"
#include "scene/gltf/gltf_deform.h"
#include "scene/gltf_document/gltf_losses.h"
#include "scene/gltf/gltf_mend.h"
#include "scene/gltf/gltf_topology.h"
#include "scene/index.h"
#include "scene/normals.h"
#include "scene/tangents.h"

#include <glm/common.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace lambent::scene {
namespace {

const gltf::Primitive& find_primitive(const Document& document, int mesh, int primitive)
{
    return document.model.meshes[at(mesh)].primitives[at(primitive)];
}

std::string primitive_name(int mesh, int primitive)
{
    return text("mesh ", mesh, ", primitive ", primitive);
}

// The vertex indices of a primitive, and the index among them that restarts it.
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
    corners.restart = restart_index(document.model.accessors[at(part.primitive.indices)].component_type);
    std::uint32_t largest = 0;
    for (const std::uint32_t corner : corners.list)
        largest = std::max(largest, corner == corners.restart ? 0 : corner);
    if (!corners.list.empty() && largest >= vertices)
        document.fail(part.name, ": index ", largest, " is past its ", vertices, " vertices");
    return corners;
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

// Returns the largest absolute coordinate. Removes elements whose positions are not finite, and throws if none are
// left.
float check_positions(const Document& document, const PrimitivePart& part, Mesh& mesh, PrimitiveNotes& notes)
{
    glm::vec3 reach(0.0f);
    const auto broken = std::find_if(mesh.positions.begin(), mesh.positions.end(),
                                     [](const glm::vec3& position) { return !is_finite(position); });
    if (broken != mesh.positions.end()) {
        const auto vertex = static_cast<std::size_t>(broken - mesh.positions.begin());
        notes.broken_elements = remove_broken_elements(mesh);
        if (is_empty(mesh))
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

// Completes normals and tangents last, since morph targets and skins move the vertices that these depend on. Points
// and lines get no normals, and no tangents for normal maps. [glTF 2.0, 3.9.6]
void complete(const TextureNeeds& needs, Mesh& mesh, PrimitiveNotes& notes)
{
    for (auto& [number, set] : mesh.texcoords)
        notes.replaced_texcoords += replace_not_finite(set, 0.0f);
    notes.replaced_colors += replace_not_finite(mesh.colors, 1.0f);
    notes.clamped_colors += clamp_colors(mesh.colors);
    for (const int set : needs.texcoords)
        notes.missing_texcoords += std::as_const(mesh).texcoords[set].empty() ? 1 : 0;
    if (!has_lines(mesh)) {
        complete_triangles(needs, mesh, notes);
    } else if (!mesh.normals.empty()) {
        notes.rebuilt_normals += repair_normals(mesh);
        notes.rebuilt_tangents += repair_tangents(mesh);
    }
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
    broken_elements += other.broken_elements;
    return *this;
}

bool is_drawable(const Document& document, int mesh, int primitive)
{
    const gltf::Primitive& source = find_primitive(document, mesh, primitive);
    if (source.mode < gltf::Mode::points || source.mode > gltf::Mode::triangle_fan)
        document.fail(primitive_name(mesh, primitive), ": mode ", source.mode, " is not defined by glTF");
    return source.attributes.contains("POSITION");
}

std::uint64_t check_request(const Document& document, const PrimitiveRequest& request)
{
    const gltf::Primitive& primitive = find_primitive(document, request.mesh, request.primitive);
    const std::string name = primitive_name(request.mesh, request.primitive);
    std::uint64_t sparse = 0;
    const auto check = [&](int accessor, const std::string& what) {
        const AccessorUse use{accessor, name + ", " + what, false, {}};
        check_accessor(document, use);
        sparse += sparse_count(document, accessor);
        return static_cast<std::uint64_t>(accessor_count(document, use));
    };
    // A faulty attribute is left out, and reported, when it is read.
    const auto check_if_whole = [&](int accessor, const std::string& what) {
        try {
            check(accessor, what);
        } catch (const Error&) {
        }
    };
    const int position = primitive.attributes.at("POSITION");
    accessor_count(document, {position, name + ", POSITION", false, {}});
    const gltf::Accessor& positions = document.model.accessors[at(position)];
    if (positions.buffer_view < 0 && !positions.sparse && primitive.has_draco)
        document.fail(name,
                      ": its geometry is compressed by KHR_draco_mesh_compression, which is not supported");
    std::uint64_t visits = check(position, "POSITION");
    if (primitive.indices >= 0)
        visits = check(primitive.indices, "indices");
    for (const auto& [attribute_name, accessor] : primitive.attributes)
        if (is_read(attribute_name, request.needs))
            check_if_whole(accessor, attribute_name);
    std::uint64_t passes = 1;
    for (std::size_t target = 0; target < primitive.targets.size(); ++target) {
        if (target >= request.weights.size() || request.weights[target] == 0.0)
            continue;
        ++passes;
        for (const auto& [attribute_name, accessor] : primitive.targets[target])
            if (is_read(attribute_name, request.needs))
                check_if_whole(accessor, text("target ", target, " ", attribute_name));
    }
    return visits * passes + sparse;
}

namespace {

void read(const Document& document, const PrimitiveRequest& request, Losses& losses, PrimitiveResult& result)
{
    const gltf::Primitive& primitive = find_primitive(document, request.mesh, request.primitive);
    PrimitivePart part{primitive, primitive_name(request.mesh, request.primitive), {}};
    const std::size_t vertices = accessor_count(document, *find_attribute(part, "POSITION"));

    Mesh& mesh = result.mesh;
    {
        const Corners corners = corner_list(document, part, vertices);
        const UnusedCorners unused = connect(corners.list, corners.restart, primitive.mode, mesh);
        result.notes.left_over_indices = unused.left_over;
        result.notes.restarts = unused.restarts;
    }
    if (is_empty(mesh))
        return;
    const std::vector<std::uint32_t> selection = choose_vertices(mesh, vertices);
    part.selection = selection;
    read_attributes(document, part, request.needs, losses, mesh);
    result.of_lines = has_lines(mesh);
    result.unlit = result.of_lines && mesh.normals.empty();
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
        PrimitiveResult lost = lost_primitive(error);
        lost.of_lines = result.of_lines;
        lost.unlit = result.unlit;
        return lost;
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
