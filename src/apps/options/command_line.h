// The command line's commands and options by name. CLI11 stays behind this header: the compiler takes seconds over it.
#pragma once

#include "apps/options/given.h"
#include "apps/options/option.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace lambent::cli {

/// A command while its options are named; the program is one, too. A handle: copies name the same command.
class Command {
public:
    explicit Command(CLI::App& app) : app_(&app) {}

    Command add_subcommand(const std::string& name, const std::string& help);

    /// Under a heading of the help. The parsing adds its words to `given`, which must outlive it: of what may be given the
    /// last, which is not empty.
    void add(const Option& option, std::string_view heading, Given& given);

    /// After parsing: whether it is the command that was given.
    bool parsed() const;

private:
    CLI::App* app_;
};

/// What the program says of itself.
struct Introduction {
    std::string name, about, version;
    std::string footer; ///< below the list of commands
};

class CommandLine {
public:
    explicit CommandLine(const Introduction& introduction);
    ~CommandLine();

    Command program() { return Command(*app_); }

    /// Fills the words. What is to be printed and nothing else, where help or the version is asked for: by --help, or as
    /// a command of its own, `help [COMMAND]`. `words` are main's, the program's name first. Throws Error(usage), with
    /// what was probably meant where a command or an option is mistyped.
    std::optional<std::string> parse(int count, const char* const* words);

private:
    std::unique_ptr<CLI::App> app_;
};

} // namespace lambent::cli
