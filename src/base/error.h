// Errors and warnings. Depends on no other file.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace lambent {

/// Kinds of failure.
enum class Failure {
    over_bound,   ///< images differ by more than the caller allows
    usage,        ///< the caller asked for something that does not exist or does not fit
    bad_input,    ///< a file is missing, broken, hostile or of an unsupported format
    no_device,    ///< no suitable processor, GPU or driver
    cannot_write, ///< the output could not be created, written or renamed
};

/// A failure that a user can act on: one line that names the file, the position in it and the reason.
class Error : public std::runtime_error {
public:
    Error(Failure failure, const std::string& line) : std::runtime_error(line), failure_(failure) {}

    Failure failure() const { return failure_; }

private:
    Failure failure_;
};

/// Problems that the user should know of but that do not stop the work: one line each, in the order found.
using Warnings = std::vector<std::string>;

} // namespace lambent
