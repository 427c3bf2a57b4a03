// What a glTF `uri` leads to: bytes in the URI itself, or a file beside the .gltf.
#pragma once

#include "scene/gltf_document/gltf_source.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lambent::scene {

/// Whether the URI holds its bytes itself ("data:...").
bool is_data_uri(std::string_view uri);

/// The bytes of a base64 data URI. `where` starts the message of the Error(bad_input) thrown for another
/// encoding or a character outside the alphabet.
std::vector<std::uint8_t> decode_data_uri(std::string_view uri, const std::string& where);

/// Where a glTF's relative URIs start, and how far they may lead.
struct UriBase {
    std::optional<std::filesystem::path> folder; ///< of the file; none: there are no files beside it
    Reach reach;
};

/// The path that a URI names: percent-decoded, `\` taken for `/`, "." and ".." worked out [RFC 3986, 5.2.4]. Throws
/// Error(bad_input), starting with `where`, for a scheme, an absolute path, or a path that leaves the reach.
std::filesystem::path path_beside(const UriBase& base, std::string_view uri, const std::string& where);

/// Throws Error(bad_input) where links lead a path that is there out of the reach.
void check_links(const UriBase& base, const std::filesystem::path& path, const std::string& where);

} // namespace lambent::scene
