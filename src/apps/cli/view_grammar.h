// The part of the command line that belongs to `lambent view`.
#pragma once

#include "apps/cli/picture_grammar.h"

namespace lambent::cli {

/// Must outlive the parsing: CLI11 fills its members.
class ViewGrammar {
public:
    /// Adds the command.
    void add(CLI::App& app);

    bool parsed() const { return command_->parsed(); }

    /// Throws Error(usage).
    ViewArguments result() const { return {picture_.start()}; }

private:
    CLI::App* command_ = nullptr;
    PictureGrammar picture_;
};

} // namespace lambent::cli
