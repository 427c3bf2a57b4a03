// Output on standard error: warnings, remarks, a progress bar.
#pragma once

#include "apps/options/arguments.h"
#include "base/error.h"

#include <chrono>
#include <string>

namespace lambent::cli {

class Console {
public:
    explicit Console(Verbosity verbosity);

    /// Prints "lambent: warning: LINE" for each, unless quiet.
    void warn(const Warnings& warnings) const;

    /// Prints warnings about input files. If `common.strict`, throws them instead, as refuse_warnings does.
    void warn_of_input(const Warnings& warnings, const CommonOptions& common) const;

    /// Prints a remark, only if verbose.
    void remark(const std::string& line) const;

    /// Shows a bar with the time left, and a note if any, once work has taken over a second. Does nothing if quiet or
    /// if standard error is no terminal. `done`: 0 to 1.
    void progress(float done, const std::string& note = {});

    /// Removes the bar.
    void end_progress();

private:
    using Clock = std::chrono::steady_clock;
    Verbosity verbosity_;
    bool terminal_;
    bool shown_ = false;
    Clock::time_point start_ = Clock::now(), last_ = start_;
};

/// Throws Error(bad_input) if there are any, with the first and the number of others.
void refuse_warnings(const Warnings& warnings);

} // namespace lambent::cli
