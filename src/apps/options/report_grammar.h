// The part of the command line that belongs to `lambent report`.
#pragma once

#include "apps/options/arguments.h"
#include "apps/options/grammar.h"

namespace lambent::cli {

/// Must outlive the parsing, which fills its members.
class ReportGrammar {
public:
    /// Adds the command.
    void add(Command& app);

    bool parsed() const { return command_.parsed(); }

    /// Throws Error(usage).
    ReportArguments result() const;

private:
    Command command_;
    CommonWords common_;
    ReportArguments arguments_;
    std::string size_, rotation_, noise_, samples_, backend_;
    bool no_cache_ = false;
};

} // namespace lambent::cli
