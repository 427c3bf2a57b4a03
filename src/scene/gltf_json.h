// From JSON text to a document whose every remaining property has the right type.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace lambent::scene {

/// Parses the JSON of a glTF and keeps what the loader uses, nothing else (no extras, no unknown
/// extensions). Brackets may nest 64 deep, and the text may hold 4 million values: both are counted before
/// anything is built, and the lists of the top level while they are, so that hostile text costs neither stack
/// nor memory.
/// Throws Error(bad_input) starting with `file`.
nlohmann::json parse_gltf_json(std::string_view text, const std::string& file);

/// How many elements are read of a list at the top level of a document; none: nothing there has that name.
std::optional<std::size_t> top_level_limit(std::string_view name);

/// Checks every property of the document against the glTF 2.0 schema as far as the loader relies on it, and
/// drops what it does not: indices and sizes become unsigned integers (3.0 counts as 3), numbers become
/// doubles that fit a float, arrays have their fixed length, required properties are there.
/// Throws Error(bad_input) naming the element, like "accessor 3".
void check_schema(nlohmann::json& document, const std::string& file);

} // namespace lambent::scene
