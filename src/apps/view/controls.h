// Controls for the parameters of the viewer.
#pragma once

#include "apps/viewer/parameters.h"
#include "apps/viewer/session.h"

namespace lambent::view_window {

/// Shows a control for each parameter, under the headings of their groups. Changes are applied to the session at once;
/// a right click sets the default. Throws Error(usage) where a value is refused.
void show_controls(viewer::Session& session, const cli::RenderArguments& asked);

} // namespace lambent::view_window
