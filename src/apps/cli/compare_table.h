// What `compare` found, for people.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace lambent::cli {

/// The object that `compare` prints for programs as lines for people: a name, a value, a unit; null is said in words.
std::string compare_table(const nlohmann::ordered_json& findings);

} // namespace lambent::cli
