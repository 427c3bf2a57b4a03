// What can go wrong, and how warnings travel. Depends on nothing.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace lambent {

/// Kinds of failure, by who can do something about it.
enum class Failure {
    over_bound,   ///< pictures differ by more than the caller allows
    usage,        ///< the caller asked for something that does not exist or does not fit
    bad_input,    ///< a file is missing, broken, hostile or of a kind we do not read
    no_device,    ///< no suitable processor, GPU or driver
    cannot_write, ///< the output could not be created, written or renamed
};

/// A failure that a user can act on: one line, naming the file, the place and the reason.
class Error : public std::runtime_error {
public:
    Error(Failure failure, const std::string& line) : std::runtime_error(line), failure_(failure) {}

    Failure failure() const { return failure_; }

private:
    Failure failure_;
};

/// Things the user should know though the work goes on: one line each, in the order found.
using Warnings = std::vector<std::string>;

} // namespace lambent
