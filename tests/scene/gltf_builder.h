// Assembles small glTF files: JSON by hand, binary data appended piece by piece.
#pragma once

#include "base/error.h"
#include "scene/scene.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace lambent::scene::test {

using nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

// glTF's names for numbers. [glTF 2.0, 3.6.2.2]
enum Component : int { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

/// One accessor more, as the file would say it.
struct NewAccessor {
    const char* type = "VEC3";
    int component = f32;
    std::size_t count = 0;
    bool normalized = false;
    std::size_t stride = 0; ///< byteStride of its bufferView; 0: none
};

class GltfBuilder {
public:
    /// The document; change anything before taking the file.
    json document = {{"asset", {{"version", "2.0"}}}};
    Bytes binary;

    /// Appends bytes as a bufferView of their own (at a multiple of four) and returns its index.
    int add_view(const Bytes& bytes, std::size_t stride = 0);
    int add_accessor(const NewAccessor& accessor, const Bytes& bytes);

    template <class Number>
    int add(const char* type, int component, std::vector<Number> numbers, bool normalized = false);

    int add_vec3(const std::vector<float>& numbers) { return add("VEC3", f32, numbers); }
    int add_vec2(const std::vector<float>& numbers) { return add("VEC2", f32, numbers); }
    int add_vec4(const std::vector<float>& numbers) { return add("VEC4", f32, numbers); }
    int add_indices(const std::vector<std::uint16_t>& numbers) { return add("SCALAR", u16, numbers); }

    /// Appends to a top-level array and returns the index.
    int add_to(const char* array, const json& element);

    /// A mesh of one primitive, on a node of its own that is a root of scene 0. Returns the mesh.
    int add_primitive(const json& primitive);
    int add_node(const json& node);

    /// The file as .glb, or as .gltf with the binary data in a data URI.
    Bytes glb() const;
    Bytes gltf() const;

private:
    json with_buffer(bool data_uri) const;
};

template <class Number>
Bytes bytes_of(const std::vector<Number>& numbers)
{
    Bytes bytes(numbers.size() * sizeof(Number));
    if (!numbers.empty())
        std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}

std::size_t components_of(std::string_view type);

template <class Number>
int GltfBuilder::add(const char* type, int component, std::vector<Number> numbers, bool normalized)
{
    return add_accessor({type, component, numbers.size() / components_of(type), normalized, 0},
                        bytes_of(numbers));
}

Bytes to_bytes(std::string_view text);
std::string base64(const Bytes& bytes);
Bytes make_glb(std::string_view json_text, const Bytes& binary);

/// A triangle (0,0,0), (1,0,0), (0,1,0) without anything else, drawn by node 0.
GltfBuilder triangle();

/// Loads from memory; outside files are looked for in `folder` if one is given.
Scene load(const Bytes& bytes, Warnings* warnings = nullptr, const std::filesystem::path& folder = {});
Scene load(const GltfBuilder& builder, Warnings* warnings = nullptr);

/// The one warning of loading, which succeeds; empty when there is none.
std::string complaint(const Bytes& bytes);
std::string complaint(const GltfBuilder& builder);

/// The message of the Error(bad_input) that loading throws; empty when it throws none.
std::string refusal(const Bytes& bytes);
std::string refusal(const GltfBuilder& builder);

bool contains(std::string_view text, std::string_view part);
/// Whether exactly one warning contains the text.
bool warned_once(const Warnings& warnings, std::string_view part);

} // namespace lambent::scene::test
