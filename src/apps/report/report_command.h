// `lambent report`.
#pragma once

#include "apps/options/arguments.h"

namespace lambent::cli {

/// Throws Error.
void run(const ReportArguments& arguments);

} // namespace lambent::cli
