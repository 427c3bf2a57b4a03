// The results of `compare` as a table for a terminal.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace lambent::cli {

/// Formats the JSON object of `compare`: lines of name, value and unit, with words in place of null.
std::string compare_table(const nlohmann::ordered_json& findings);

} // namespace lambent::cli
