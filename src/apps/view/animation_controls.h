// Controls for a scene that moves.
#pragma once

#include "apps/viewer/session.h"

namespace lambent::view_window {

/// Which animation, a button that lets it go on or stops it, its moment; nothing where the scene has none. What is moved is
/// set at once. Throws Error(usage).
void show_animation(viewer::Session& session);

} // namespace lambent::view_window
