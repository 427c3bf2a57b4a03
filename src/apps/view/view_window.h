// `lambent view`: a window that shows one session.
#pragma once

#include "apps/options/arguments.h"

namespace lambent::view_window {

/// Runs until the window is closed. Throws Error, also where no window can be opened.
void run(const cli::ViewArguments& arguments);

} // namespace lambent::view_window
