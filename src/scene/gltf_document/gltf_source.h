// Where a glTF comes from, and what it may lead to.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lambent::scene {

/// How far the relative URIs of a glTF may lead.
struct Reach {
    bool anywhere = false;                      ///< to any file that this user may read
    std::vector<std::filesystem::path> folders; ///< else to these and below; none: the glTF's own
};

/// A file that is in memory already.
struct GltfSource {
    std::string file;                            ///< the name that messages start with
    std::span<const std::uint8_t> bytes;         ///< a whole .gltf or .glb
    std::optional<std::filesystem::path> folder; ///< where relative URIs start; none: they are refused
    Reach reach{};                               ///< how far they may lead
};

} // namespace lambent::scene
