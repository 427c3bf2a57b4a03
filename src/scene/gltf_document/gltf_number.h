// JSON's numbers as glTF wants them.
#pragma once

#include "scene/gltf_document/gltf_table.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace lambent::scene {

/// The reason why a value is no whole number from 0 up to `most`, or nothing: then `whole` is the number. JSON knows no
/// integers: 3.0 and 3e0 are 3. [JSON Schema, "integer"]
std::string read_whole(const nlohmann::json& value, double most, std::string_view name, std::uint64_t& whole);

/// The reason why a value is no number that fits a float, or nothing.
std::string check_number(const nlohmann::json& value, std::string_view name);

/// The reason why one of an array's is none, or why there are not as many as the property says; or nothing.
std::string check_numbers(const nlohmann::json& array, const Property& property);

} // namespace lambent::scene
