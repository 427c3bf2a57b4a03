// The loader's entry for bytes already in memory: what load_gltf, the tests and the fuzzer call.
#pragma once

#include "base/error.h"
#include "scene/gltf.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace lambent::scene {

struct GltfSource {
    std::string file;                            ///< the name that messages start with
    std::span<const std::uint8_t> bytes;         ///< a whole .gltf or .glb
    std::optional<std::filesystem::path> folder; ///< where relative URIs start; none: they are refused
    Reach reach{};                               ///< how far they may lead
};

/// As load_gltf (scene/gltf.h), which says what is read and what is refused.
Scene load_gltf_bytes(const GltfSource& source, Warnings& warnings);

} // namespace lambent::scene
