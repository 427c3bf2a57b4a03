// The tables of options in docs/CLI.md, made from the table of options.
#pragma once

#include <string>

namespace lambent::cli {

/// The page with its tables of options made anew: below each heading "## COMMAND", and "## Everywhere", the first table.
std::string with_option_tables(const std::string& page);

} // namespace lambent::cli
