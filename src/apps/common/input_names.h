// Names of scenes and environments: built-in ones and files.
#pragma once

#include <string>

namespace lambent::cli {

/// Throws Error(bad_input), with a suggestion, if there is neither a built-in scene nor a file of this name.
void check_scene_name(const std::string& name);

/// The same for environments, of which `none` is one.
void check_environment_name(const std::string& name);

} // namespace lambent::cli
