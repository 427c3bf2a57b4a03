// `lambent serve`.
#pragma once

#include "apps/options/arguments.h"

namespace lambent::cli {

/// Serves until interrupted. Throws Error.
void run(const ServeArguments& arguments);

} // namespace lambent::cli
