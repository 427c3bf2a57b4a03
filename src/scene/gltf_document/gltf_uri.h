// The URIs of a glTF, which hold data themselves or name a file beside the .gltf.
#pragma once

#include "scene/gltf_document/gltf_source.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lambent::scene {

/// Whether the URI holds data itself ("data:...").
bool is_data_uri(std::string_view uri);

/// The bytes of a base64 data URI. `where` starts the message of the Error(bad_input) thrown for another
/// encoding or a character outside the alphabet.
std::vector<std::uint8_t> decode_data_uri(std::string_view uri, const std::string& where);

/// The base of a glTF's relative URIs, and the files that they may refer to.
struct UriBase {
    std::optional<std::filesystem::path> folder; ///< of the glTF; none: there are no files beside it
    Reach reach;
};

/// The path that a URI names: percent-decoded, with `\` replaced by `/`, and "." and ".." resolved [RFC 3986, 5.2.4].
/// Throws Error(bad_input), starting with `where`, for a scheme, an absolute path, or a path outside of the reach.
std::filesystem::path path_beside(const UriBase& base, std::string_view uri, const std::string& where);

/// Throws Error(bad_input) if an existing path leads out of the reach by symbolic links.
void check_links(const UriBase& base, const std::filesystem::path& path, const std::string& where);

} // namespace lambent::scene
