// Mouse and keys, as moves of a session.
#pragma once

#include "apps/view/window.h"
#include "apps/viewer/session.h"

#include <string>
#include <vector>

namespace lambent::view_window {

/// What hands asked for besides moves.
struct Asked {
    bool close = false, save = false, copy = false, help = false, panel = false;
};

/// The mouse of this frame by Dear ImGui, whose controls come first, and keys.
Asked move(viewer::Session& session, const std::vector<Window::Key>& keys);

/// A line each: keys, and what they do.
extern const char* const hand_help;

} // namespace lambent::view_window
