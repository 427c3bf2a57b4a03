// Settings of the window that are kept between runs.
#pragma once

#include "apps/view/window_place.h"

#include <filesystem>
#include <optional>
#include <string>

namespace lambent::view_window {

struct WindowSettings {
    WindowPlace place;
    bool panel = true;
};

/// $XDG_CONFIG_HOME/lambent/view.json, or ~/.config/lambent/view.json; unset if neither variable is an absolute path.
std::optional<std::filesystem::path> settings_file();

/// Parses a file. Missing or invalid values keep their defaults. Text that cannot be parsed or has another version
/// gives the defaults and sets `complaint` to one line.
WindowSettings read_settings(const std::string& json, std::string& complaint);
std::string write_settings(const WindowSettings& settings);

/// Reads the user's file; `complaint` is set to a line with its name if it is invalid.
WindowSettings load_settings(std::string& complaint);

/// Writes the user's file. Failures are ignored: the next window then starts with the defaults.
void save_settings(const WindowSettings& settings);

} // namespace lambent::view_window
