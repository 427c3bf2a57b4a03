// Text with placeholders: "e = {exposure}".
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace lambent::report {

/// Text by the name of its placeholder.
using Values = std::map<std::string, std::string>;

/// The names of a pattern's placeholders, in order, repeated names included. Throws std::logic_error where a brace
/// has no partner.
std::vector<std::string> placeholders(std::string_view pattern);

/// The pattern with each placeholder replaced by its value. Throws std::logic_error for a placeholder without a value.
std::string fill(std::string_view pattern, const Values& values);

} // namespace lambent::report
