// Reading of a primitive of the file, which becomes one mesh.
#pragma once

#include "scene/gltf_document/gltf_document.h"
#include "scene/scene.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <cstddef>
#include <set>
#include <span>

namespace lambent::scene {

/// The vertex data that the primitive's material needs.
struct TextureNeeds {
    std::set<int> texcoords; ///< the sets that some texture reads
    int normal_map_set = -1; ///< the set of the normal texture; -1: none
    glm::mat3 normal_map_transform{1.0f};
};

struct PrimitiveRequest {
    int mesh = 0;
    int primitive = 0;
    std::span<const double> weights; ///< of the morph targets
    std::span<const glm::mat4> skin; ///< world from mesh for each joint; empty: not skinned
    TextureNeeds needs;
};

/// Counts of repairs and omissions that the user should know of.
struct PrimitiveNotes {
    std::size_t rebuilt_normals = 0;
    std::size_t rebuilt_tangents = 0;
    std::size_t replaced_texcoords = 0;     ///< were not finite: now 0
    std::size_t replaced_colors = 0;        ///< were not finite: now 1
    std::size_t left_over_indices = 0;      ///< after the last whole triangle or line
    std::size_t missing_texcoords = 0;      ///< primitives whose material reads a set they do not have
    std::size_t left_out_displacements = 0; ///< morph targets of texture coordinates or colours
    std::size_t clamped_colors = 0;         ///< were outside of [0, 1]
    std::size_t restarts = 0;               ///< indices that restart the primitive
    std::size_t broken_elements =
        0; ///< triangles, lines and points of positions that are not finite: left out

    PrimitiveNotes& operator+=(const PrimitiveNotes& other);
};

struct PrimitiveResult {
    Mesh mesh;             ///< material left at 0; empty where the primitive has no triangle, line or point
    bool in_world = false; ///< skinned: the node's transform does not apply
    bool of_lines = false; ///< lines or points, also if these are lost
    bool unlit = false;    ///< without normals: lines or points only
    float reach = 0.0f;    ///< largest absolute coordinate of a position
    PrimitiveNotes notes;
    Warnings faults;      ///< one line for each part that was left out
    bool is_lost = false; ///< left out whole: an empty mesh
    std::string loss;     ///< the reason; empty if it was reported before
};

/// Whether the primitive has positions. Throws Error(bad_input) for an unknown mode.
bool is_drawable(const Document& document, int mesh, int primitive);

/// Checks the accessors that the request requires, and returns how many elements reading it visits: the loader's
/// measure of work. Throws Error(bad_input).
std::uint64_t check_request(const Document& document, const PrimitiveRequest& request);

/// Reads, deforms, and completes the vertices (normals, tangents). Attributes, morph targets and skins that cannot be
/// read are left out; the whole primitive is lost if its positions or indices cannot be read.
PrimitiveResult read_primitive(const Document& document, const PrimitiveRequest& request);

/// The result for a primitive that cannot be read.
PrimitiveResult lost_primitive(const Error& error);

} // namespace lambent::scene
