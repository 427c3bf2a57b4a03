// Typed, bounds-checked reading of accessors.
#pragma once

#include "scene/gltf_document/gltf_document.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lambent::scene {

/// A request to read an accessor.
struct AccessorUse {
    int accessor = -1;
    std::string what;        ///< the accessor's user, for messages: "mesh 0, primitive 1, POSITION"
    bool normalized = false; ///< integers are fractions even if the accessor is not marked so
    std::span<const std::uint32_t> selection; ///< ascending elements to read, below its count; empty: all
};

/// Number of elements. Throws if the accessor does not exist.
std::size_t accessor_count(const Document& document, const AccessorUse& use);

/// Throws if the accessor's elements are not all inside its bufferView, or if it has none and more than a million
/// elements.
void check_accessor(const Document& document, const AccessorUse& use);

/// Number of elements that its sparse part overrides.
std::size_t sparse_count(const Document& document, int accessor);

/// Elements as floats. Integers are converted as glTF defines: to fractions of their largest value if the accessor is
/// normalized, else to their plain value. Sparse parts are applied; a missing bufferView reads as zeros (at most a
/// million elements). [glTF 2.0, 3.6.2] Throws Error(bad_input) if bytes are missing or the type differs.
std::vector<glm::vec2> read_vec2(const Document& document, const AccessorUse& use);
std::vector<glm::vec3> read_vec3(const Document& document, const AccessorUse& use);
std::vector<glm::vec4> read_vec4(const Document& document, const AccessorUse& use);
/// VEC3 or VEC4; a missing fourth component is 1.
std::vector<glm::vec4> read_color(const Document& document, const AccessorUse& use);
/// Column-major MAT4 of floats.
std::vector<glm::mat4> read_mat4(const Document& document, const AccessorUse& use);

/// SCALAR. As above.
std::vector<float> read_scalars(const Document& document, const AccessorUse& use);
/// Throws if the accessor's numbers are not floats.
void check_floats(const Document& document, const AccessorUse& use);

/// SCALAR of unsigned 8, 16 or 32 bit integers. As above.
std::vector<std::uint32_t> read_indices(const Document& document, const AccessorUse& use);
/// VEC4 of unsigned 8 or 16 bit integers. As above.
std::vector<glm::u16vec4> read_joints(const Document& document, const AccessorUse& use);

} // namespace lambent::scene
