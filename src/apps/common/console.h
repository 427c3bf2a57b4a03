// What is said on standard error: warnings, remarks, a progress bar.
#pragma once

#include "apps/options/arguments.h"
#include "base/error.h"

#include <chrono>
#include <string>

namespace lambent::cli {

class Console {
public:
    explicit Console(Verbosity verbosity);

    /// "lambent: warning: LINE", unless quiet.
    void warn(const Warnings& warnings) const;

    /// The same of the files that a command reads. Throws Error(bad_input) with the first, where they are to be errors.
    void warn_of_input(const Warnings& warnings, const CommonOptions& common) const;

    /// A remark, only if verbose.
    void remark(const std::string& line) const;

    /// A bar with the time left, and a note if any, if work has taken over a second and standard error is a terminal;
    /// not if quiet.
    void progress(float done, const std::string& note = {});

    /// Takes the bar away.
    void end_progress();

private:
    using Clock = std::chrono::steady_clock;
    Verbosity verbosity_;
    bool terminal_;
    bool shown_ = false;
    Clock::time_point start_ = Clock::now(), last_ = start_;
};

/// Throws Error(bad_input) if there are any: with the first, and how many there are.
void refuse_warnings(const Warnings& warnings);

} // namespace lambent::cli
