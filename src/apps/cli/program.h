// What every program of lambent does around its work.
#pragma once

#include <functional>

namespace lambent::cli {

/// Does the work and returns the exit code: 0, or, after one line on standard error, that of what was thrown. A file over
/// the user's limit is a failed write, as on a full disk, and no end of the program. Flushes standard output.
int run_program(const std::function<void()>& work);

} // namespace lambent::cli
