// Settings of the window that are kept between runs.
#pragma once

#include "apps/view/window_place.h"

#include <filesystem>
#include <optional>
#include <string>

namespace lambent::view_window {

struct Memory {
    WindowPlace place;
    bool panel = true;
};

/// $XDG_CONFIG_HOME/lambent/view.json, or ~/.config/lambent/view.json; unset if neither variable is an absolute path.
std::optional<std::filesystem::path> memory_file();

/// Parses a file. Missing or invalid values keep their defaults. Text that cannot be parsed or has another version
/// gives the defaults and sets `complaint` to one line.
Memory read_memory(const std::string& json, std::string& complaint);
std::string write_memory(const Memory& memory);

/// Reads the user's file; `complaint` is set to a line with its name if it is invalid.
Memory load_memory(std::string& complaint);

/// Writes the user's file. Failures are ignored: the next window then starts with the defaults.
void keep_memory(const Memory& memory);

} // namespace lambent::view_window
