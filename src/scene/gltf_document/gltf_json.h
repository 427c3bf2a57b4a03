// From JSON text to a document of what the tables know.
#pragma once

#include "scene/gltf_document/gltf_table.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace lambent::scene {

/// Parses JSON and keeps what the shape has names for, nothing else: no extras, no unknown extensions, no list or object
/// where the shape has something else (an empty one stands for it, or null in a list). So a document is never nested deeper
/// than its shape, and what is not kept costs no memory, whatever it holds and however deep it nests.
/// Throws Error(bad_input) starting with `file`.
nlohmann::json parse_json(std::string_view text, const Shape& shape, const std::string& file);

} // namespace lambent::scene
