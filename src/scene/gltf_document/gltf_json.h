// From JSON text to a document whose every remaining property has the right type.
#pragma once

#include "scene/gltf_document/gltf_losses.h"

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

/// What an index becomes that is none: there is nothing of that number.
inline constexpr int unreadable_index = 2147483647;

/// The extension that an element bears which stands for one that could not be read. A file's own extensions of that name
/// are not kept.
inline constexpr const char* broken_mark = "broken";

/// Checks every property of the document against the glTF 2.0 schema as far as the loader relies on it, and
/// drops what it does not: indices and sizes become unsigned integers (3.0 counts as 3), numbers become
/// doubles that fit a float, arrays have their fixed length, required properties are there. What does not fit is left
/// out with a warning naming the element, like "accessor 3" (scene/gltf_document/gltf_checker.h).
/// Returns the first loss that may have cost something to draw, as one line, or nothing. Throws Error(bad_input) for what
/// is too much.
std::string check_schema(nlohmann::json& document, const std::string& file, Losses& losses);

} // namespace lambent::scene
