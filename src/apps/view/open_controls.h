// Controls to open models and environments.
#pragma once

#include "apps/viewer/file_list.h"
#include "apps/viewer/view_request.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lambent::view_window {

/// A model or an environment to open.
struct Opening {
    std::string name;
    bool is_environment = false;
};

/// Lists of files, searched for each time a list is unfolded, and a text field for a path.
class OpenControls {
public:
    explicit OpenControls(viewer::FileList files) : files_(std::move(files)) {}

    /// Shows the controls. Returns the name that was chosen or entered, if any.
    std::optional<Opening> show(const viewer::ViewRequest& request);

private:
    viewer::FileList files_;
    std::vector<std::string> names_;
    std::array<char, 4096> typed_{};
};

/// An environment if the name is that of a built-in one, "none", or ends in .hdr or .exr; otherwise a model.
Opening opening_of(const std::string& name);

/// The name in a text as typed: spaces around it are removed, and "~/" is replaced by the home folder.
std::string as_typed(const std::string& words);

} // namespace lambent::view_window
