// Mouse and keyboard input, applied to a session.
#pragma once

#include "apps/view/window.h"
#include "apps/viewer/session.h"

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace lambent::view_window {

/// Actions of the window that keys asked for.
struct Asked {
    bool close = false, save = false, copy = false, help = false, panel = false, leave = false;
};

/// Applies the mouse input of this frame, except where Dear ImGui's controls use it.
void move_by_mouse(viewer::Session& session);

/// Applies keys. To be called after the controls of the frame were shown, so that keys typed into one are ignored.
Asked press_keys(viewer::Session& session, const std::vector<Window::Key>& keys);

/// A key or mouse gesture, and its effect.
struct Shortcut {
    std::string_view keys, meaning;
    std::string_view characters; ///< any of these triggers it
    std::array<int, 4> others{}; ///< GLFW_KEY_* that trigger it; without either it is a mouse gesture
    bool control = false, repeats = false;
    void (*act)(viewer::Session& session, const Window::Key& key, Asked& asked) = nullptr;
};

/// All shortcuts, in the order of the help.
std::span<const Shortcut> shortcuts();

} // namespace lambent::view_window
