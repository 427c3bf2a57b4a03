// The part of the command line that belongs to `lambent serve`.
#pragma once

#include "apps/options/picture_grammar.h"

namespace lambent::cli {

/// Must outlive the parsing, which fills its members.
class ServeGrammar {
public:
    /// Adds the command.
    void add(Command& app);

    bool parsed() const { return command_.parsed(); }

    /// Throws Error(usage).
    ServeArguments result() const;

private:
    Command command_;
    PictureGrammar picture_;
    ServeArguments arguments_;
    std::string port_, sessions_;
};

} // namespace lambent::cli
