// What every program of lambent does around its work.
#pragma once

#include "base/error.h"

#include <functional>

namespace lambent::cli {

/// The exit code for each kind of failure (docs/CLI.md).
int exit_code(Failure failure);

/// Does the work and returns the exit code: 0, or, after one line on standard error, that of what was thrown. A file over
/// the user's limit is a failed write, as on a full disk, and no end of the program. Flushes standard output.
int run_program(const std::function<void()>& work);

} // namespace lambent::cli
