// The part of the command line that belongs to `lambent view`.
#pragma once

#include "apps/options/picture_grammar.h"

namespace lambent::cli {

/// Must outlive the parsing, which fills its members.
class ViewGrammar {
public:
    /// Adds the command.
    void add(Command& app);

    bool parsed() const { return command_.parsed(); }

    /// Throws Error(usage).
    ViewArguments result() const { return {picture_.start()}; }

private:
    Command command_;
    PictureGrammar picture_;
};

} // namespace lambent::cli
