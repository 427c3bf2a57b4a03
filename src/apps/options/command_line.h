// Commands and options of the command line, parsed by CLI11. Only command_line.cpp includes CLI11: it takes seconds to
// compile.
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

/// A command to which options are added; the program is one, too. A handle: copies refer to the same command.
class Command {
public:
    explicit Command(CLI::App& app) : app_(&app) {}

    Command add_subcommand(const std::string& name, const std::string& help);

    /// Adds an option under a heading of the help. Parsing adds its words to `given`, which must outlive the parsing.
    /// Of an option of Form::option that is given several times, the last word counts; it must not be empty.
    void add(const Option& option, std::string_view heading, Given& given);

    /// Whether parsing found this command.
    bool parsed() const;

private:
    CLI::App* app_;
};

/// Texts about the program, for its help.
struct Introduction {
    std::string name, about, version;
    std::string footer; ///< below the list of commands
};

class CommandLine {
public:
    explicit CommandLine(const Introduction& introduction);
    ~CommandLine();

    Command program() { return Command(*app_); }

    /// Parses main's `words`, the program's name first. Returns the text to print if help or the version is asked for,
    /// by --help, --version or the command `help [COMMAND]`. Throws Error(usage), with a suggestion where a command or
    /// an option is mistyped.
    std::optional<std::string> parse(int count, const char* const* words);

private:
    std::unique_ptr<CLI::App> app_;
};

} // namespace lambent::cli
