// The source of a glTF, and the files that it may refer to.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lambent::scene {

/// The files that the relative URIs of a glTF may refer to.
struct Reach {
    bool anywhere = false;                      ///< any file that the user may read
    std::vector<std::filesystem::path> folders; ///< else files in or below these; empty: the glTF's folder
};

/// A glTF file in memory.
struct GltfSource {
    std::string file;                            ///< the name that messages start with
    std::span<const std::uint8_t> bytes;         ///< a whole .gltf or .glb
    std::optional<std::filesystem::path> folder; ///< base of relative URIs; none: these are refused
    Reach reach{};                               ///< files that these may refer to
};

} // namespace lambent::scene
