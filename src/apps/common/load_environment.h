// The environment that a command line names.
#pragma once

#include "environment/environment.h"

#include <optional>
#include <string>

namespace lambent::cli {

struct LoadedEnvironment {
    std::optional<environment::Environment> environment; ///< unset: "none"
    Warnings warnings;
    bool cached = false; ///< read from the cache
};

/// Prepares a built-in environment or a file; with `cache`, keeps it in the user's cache folder. Throws
/// Error(bad_input).
LoadedEnvironment load_environment(const std::string& name, bool cache);

} // namespace lambent::cli
