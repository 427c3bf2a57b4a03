// What a viewer's program does before it shows anything.
#pragma once

#include "apps/common/console.h"
#include "apps/viewer/asset_cache.h"
#include "apps/viewer/view_request.h"

namespace lambent::viewer {

/// Loads what the command line names, says what there is to warn of, and returns what is to be seen at first.
/// Throws Error.
ViewRequest load_first(const cli::StartArguments& arguments, AssetCache& assets, const cli::Console& console);

} // namespace lambent::viewer
