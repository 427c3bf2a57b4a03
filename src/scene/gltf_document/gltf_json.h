// Parsing of JSON text, restricted to the properties in the schema tables.
#pragma once

#include "scene/gltf_document/gltf_table.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace lambent::scene {

/// Parses JSON and keeps only the properties that the shape names: no extras, no unknown extensions. A list or object
/// where the shape has another kind becomes an empty one, or null in a list. The document is therefore never nested
/// deeper than its shape, and skipped values take no memory, however large and however deeply nested they are. Throws
/// Error(bad_input) starting with `file`.
nlohmann::json parse_json(std::string_view text, const Shape& shape, const std::string& file);

} // namespace lambent::scene
