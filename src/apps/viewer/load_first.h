// What a viewer's program does before it shows anything.
#pragma once

#include "apps/common/console.h"
#include "apps/viewer/stock.h"
#include "apps/viewer/wish.h"

namespace lambent::viewer {

/// Loads what the command line names, says what there is to warn of, and returns what is to be seen at first.
/// Throws Error.
Wish load_first(const cli::StartArguments& arguments, Stock& stock, const cli::Console& console);

} // namespace lambent::viewer
