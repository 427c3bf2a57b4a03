// The container of a glTF file: GLB chunks or bare JSON.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace lambent::scene {

/// Views of the file's bytes.
struct Container {
    std::string_view json;
    std::span<const std::uint8_t> binary; ///< the BIN chunk; empty without one
};

/// Tells .glb from .gltf by the first bytes and finds the JSON text and the binary chunk.
/// Throws Error(bad_input) for a wrong magic, version, header length or chunk length. [glTF 2.0, 4.4]
Container open_container(std::span<const std::uint8_t> bytes, const std::string& file);

} // namespace lambent::scene
