// Loading what a viewer shows first.
#pragma once

#include "apps/common/console.h"
#include "apps/viewer/asset_cache.h"
#include "apps/viewer/view_request.h"

namespace lambent::viewer {

/// Loads the scene and the environment of the command line, prints their warnings, and returns the first request.
/// Throws Error.
ViewRequest load_first(const cli::StartArguments& arguments, AssetCache& assets, const cli::Console& console);

} // namespace lambent::viewer
