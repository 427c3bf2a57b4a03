// Controls for the viewer's table of parameters.
#pragma once

#include "apps/viewer/parameters.h"
#include "apps/viewer/session.h"

namespace lambent::view_window {

/// A control for each row of the table, under the names of its groups. What is moved is set at once; a right click sets the default. Throws Error(usage) where a value is refused.
void show_controls(viewer::Session& session, const cli::RenderArguments& asked);

} // namespace lambent::view_window
