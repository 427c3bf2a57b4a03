// Mouse and keys, as moves of a session.
#pragma once

#include "apps/view/window.h"
#include "apps/viewer/session.h"

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace lambent::view_window {

/// What hands asked for besides moves.
struct Asked {
    bool close = false, save = false, copy = false, help = false, panel = false, leave = false;
};

/// The mouse of this frame, by Dear ImGui, whose controls come first.
void move_by_mouse(viewer::Session& session);

/// After the controls of the frame were shown, so that what is typed into one moves nothing.
Asked press_keys(viewer::Session& session, const std::vector<Window::Key>& keys);

/// What each does, in the order of the help: all there are.
struct Shortcut {
    std::string_view keys, meaning;
    std::string_view characters; ///< that do it
    std::array<int, 4> others{}; ///< GLFW_KEY_* that do it; both empty: the mouse does
    bool control = false, repeats = false;
    void (*act)(viewer::Session& session, const Window::Key& key, Asked& asked) = nullptr;
};
std::span<const Shortcut> shortcuts();

} // namespace lambent::view_window
