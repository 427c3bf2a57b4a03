// The part of the command line that belongs to `lambent compare`.
#pragma once

#include "apps/options/arguments.h"
#include "apps/options/grammar.h"

namespace lambent::cli {

/// Must outlive the parsing, which fills its members.
class CompareGrammar {
public:
    /// Adds the command.
    void add(Command& app);

    bool parsed() const { return command_.parsed(); }

    /// Throws Error(usage).
    CompareArguments result() const;

private:
    Command command_;
    CommonWords common_;
    CompareArguments arguments_;
    std::string heat_, exposure_, clamp_, pixels_per_degree_, max_flip_, max_relative_;
};

} // namespace lambent::cli
