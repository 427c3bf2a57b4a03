// What the window remembers from one time to the next.
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

/// $XDG_CONFIG_HOME/lambent/view.json, or under ~/.config; none where there is neither.
std::optional<std::filesystem::path> memory_file();

/// From a file's text. What it does not say, or says wrongly, or another version says, is as usual; `complaint` then has
/// a line.
Memory read_memory(const std::string& json, std::string& complaint);
std::string write_memory(const Memory& memory);

/// From the user's file; `complaint` gets a line that names it if it is broken.
Memory load_memory(std::string& complaint);

/// Into the user's file. Where it cannot be kept the next window starts as usual: no reason to fail.
void keep_memory(const Memory& memory);

} // namespace lambent::view_window
