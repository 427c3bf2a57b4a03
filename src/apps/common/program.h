// Error handling and exit codes of every program.
#pragma once

#include "base/error.h"

#include <functional>

namespace lambent::cli {

/// The exit code for each kind of failure (docs/CLI.md).
int exit_code(Failure failure);

/// Does the work and returns the exit code: 0, or that of the exception, after one line about it on standard error. A
/// file over the user's size limit is a failed write, as on a full disk, and does not kill the program. Flushes
/// standard output.
int run_program(const std::function<void()>& work);

} // namespace lambent::cli
