// The part of the command line that belongs to `lambent serve`.
#pragma once

#include "apps/cli/picture_grammar.h"

namespace lambent::cli {

/// Must outlive the parsing: CLI11 fills its members.
class ServeGrammar {
public:
    /// Adds the command.
    void add(CLI::App& app);

    bool parsed() const { return command_->parsed(); }

    /// Throws Error(usage).
    ServeArguments result() const;

private:
    CLI::App* command_ = nullptr;
    PictureGrammar picture_;
    ServeArguments arguments_;
    std::string port_, sessions_;
};

} // namespace lambent::cli
