// The part of the table of options that says how surfaces and light look, and what draws them.
#pragma once

#include "apps/options/option_table.h"

namespace lambent::cli {

Group<RenderArguments> material_group();
Group<RenderArguments> display_group();
Group<RenderArguments> device_group();

/// What only the controls of viewers set, and the bounces that they have in common with `lambent reference`.
Group<RenderArguments> viewer_group();
Group<RenderArguments> bounces_group();

} // namespace lambent::cli
