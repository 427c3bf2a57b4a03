// Ctrl-C as a request to stop early.
#pragma once

namespace lambent::cli {

/// While it exists, the first SIGINT or SIGTERM only sets a flag; one after half a second or more ends the program as usual.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    bool asked() const;

    /// Ends the program as the signal would have: for who was asked and has cleaned up.
    [[noreturn]] void end_program() const;
};

} // namespace lambent::cli
