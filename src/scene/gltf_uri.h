// What a glTF `uri` leads to: bytes in the URI itself, or a file beside the .gltf.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace lambent::scene {

/// Whether the URI holds its bytes itself ("data:...").
bool is_data_uri(std::string_view uri);

/// The bytes of a base64 data URI. `where` starts the message of the Error(bad_input) thrown for another
/// encoding or a character outside the alphabet.
std::vector<std::uint8_t> decode_data_uri(std::string_view uri, const std::string& where);

/// The path, relative to the file's folder, that a URI names: percent-decoded, `\` taken for `/`.
/// A glTF may only reach its own folder and those below: a scheme, an absolute path or a `..` that leaves the
/// folder is an Error(bad_input) starting with `where`.
std::filesystem::path relative_path(std::string_view uri, const std::string& where);

} // namespace lambent::scene
