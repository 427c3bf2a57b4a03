// Ctrl-C as a request to stop early.
#pragma once

namespace lambent::cli {

/// While it exists, the first SIGINT or SIGTERM only sets a flag; another, half a second or more later, ends the
/// program.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    bool asked() const;

    /// Ends the program as the signal would have. For callers that have cleaned up after asked().
    [[noreturn]] void end_program() const;
};

} // namespace lambent::cli
