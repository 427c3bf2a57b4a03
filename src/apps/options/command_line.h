// The command line's commands and options by name. CLI11 stays behind this header: the compiler takes seconds over it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace lambent::cli {

/// The heading of the options that all commands have.
inline constexpr const char* everywhere = "Everywhere";

/// A command while its options are named; the program is one, too. A handle: copies name the same command. The words
/// that options fill must outlive the parsing.
class Command {
public:
    Command() = default;
    explicit Command(CLI::App& app) : app_(&app) {}

    Command add_subcommand(const std::string& name, const std::string& help);

    /// The same command; what is added through this handle stands under a heading of its own in the help.
    Command under(const std::string& heading) const;

    /// Must be given: an option ("-o,--output"), or what stands by itself ("scene"). The help names its `kind`.
    void add_required(const std::string& name, std::string& word, const std::string& kind,
                      const std::string& help);

    /// May be given, with one word, of which the last counts and which is not empty.
    void add_option(const std::string& name, std::string& word, const std::string& kind,
                    const std::string& help);

    /// May be given any number of times, with one word each.
    void add_repeated(const std::string& name, std::vector<std::string>& words, const std::string& kind,
                      const std::string& help);

    void add_flag(const std::string& name, bool& flag, const std::string& help);

    /// After parsing: whether it is the command that was given.
    bool parsed() const;

private:
    CLI::App* app_ = nullptr;
    std::string heading_ = "Options";
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
