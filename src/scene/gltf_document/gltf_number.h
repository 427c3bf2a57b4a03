// Checks of numbers in JSON.
#pragma once

#include "scene/gltf_document/gltf_table.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace lambent::scene {

/// Reads a whole number from 0 to `most` into `whole`. Returns the reason why the value is not one, or an empty
/// string. JSON has no integers: 3.0 and 3e0 are 3. [JSON Schema, "integer"]
std::string read_whole(const nlohmann::json& value, double most, std::string_view name, std::uint64_t& whole);

/// Returns the reason why a value is not a number in the range of floats, or an empty string.
std::string check_number(const nlohmann::json& value, std::string_view name);

/// The same for all numbers of an array, and for their count if the property fixes it.
std::string check_numbers(const nlohmann::json& array, const Property& property);

} // namespace lambent::scene
