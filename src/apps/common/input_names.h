// Names of scenes and environments: a built-in's, or a file's.
#pragma once

#include <string>

namespace lambent::cli {

/// Throws Error(bad_input) where neither a built-in scene has the name nor anything is there under it, with the built-in
/// that was probably meant.
void check_scene_name(const std::string& name);

/// The same of environments; `none` is one.
void check_environment_name(const std::string& name);

} // namespace lambent::cli
