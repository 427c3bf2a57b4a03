// Part of the table of options: materials, display, backend, and what viewers set.
#pragma once

#include "apps/options/option_table.h"

namespace lambent::cli {

Group<RenderArguments> material_group();
Group<RenderArguments> display_group();
Group<RenderArguments> device_group();

Group<RenderArguments> bounces_group();

/// Options that only the controls of viewers set.
Group<RenderArguments> viewer_group();

} // namespace lambent::cli
