// The part of the command line that belongs to `lambent report`.
#pragma once

#include "apps/cli/arguments.h"
#include "apps/cli/grammar.h"

namespace lambent::cli {

/// Must outlive the parsing: CLI11 fills its members.
class ReportGrammar {
public:
    /// Adds the command.
    void add(CLI::App& app);

    bool parsed() const { return command_->parsed(); }

    /// Throws Error(usage).
    ReportArguments result() const;

private:
    CLI::App* command_ = nullptr;
    CommonWords common_;
    ReportArguments arguments_;
    std::string size_, rotation_, noise_, samples_, backend_;
    bool no_cache_ = false;
};

} // namespace lambent::cli
