// Controls for the animations of a scene.
#pragma once

#include "apps/viewer/session.h"

namespace lambent::view_window {

/// Shows a list of the animations, a slider for the time and a button to play or pause; nothing for a scene without
/// animations. Changes are applied to the session at once. Throws Error(usage).
void show_animation(viewer::Session& session);

} // namespace lambent::view_window
