// Controls that open models and environments.
#pragma once

#include "apps/viewer/file_list.h"
#include "apps/viewer/view_request.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lambent::view_window {

/// Something to be opened.
struct Opening {
    std::string name;
    bool is_environment = false;
};

/// What there is to open, looked for each time a list is unfolded, and the name that is being typed.
class OpenControls {
public:
    explicit OpenControls(viewer::FileList files) : files_(std::move(files)) {}

    /// What was chosen or typed, if anything.
    std::optional<Opening> show(const viewer::ViewRequest& request);

private:
    viewer::FileList files_;
    std::vector<std::string> names_;
    std::array<char, 4096> typed_{};
};

/// By its ending, or as a built-in one, an environment; everything else is a model.
Opening opening_of(const std::string& name);

/// A name as typed: without spaces around it, "~/" as the user's folder.
std::string as_typed(const std::string& words);

} // namespace lambent::view_window
