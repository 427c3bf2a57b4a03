#include "apps/cli/command_line.h"

#include "base/error.h"
#include "base/text.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <string_view>

namespace lambent::cli {
namespace {

bool knows_command(const CLI::App& app, std::string_view name)
{
    const std::vector<const CLI::App*> commands = app.get_subcommands(nullptr);
    return std::any_of(commands.begin(), commands.end(),
                       [name](const CLI::App* command) { return command->check_name(std::string(name)); });
}

// The first line of a message, for CLI11's may be long.
std::string first_line(const std::string& message)
{
    return message.substr(0, message.find('\n'));
}

} // namespace

Command Command::add_subcommand(const std::string& name, const std::string& help)
{
    return Command(*app_->add_subcommand(name, help));
}

void Command::add_required(const std::string& name, std::string& word, const std::string& kind,
                           const std::string& help)
{
    app_->add_option(name, word, help)->type_name(kind)->required();
}

void Command::add_option(const std::string& name, std::string& word, const std::string& kind,
                         const std::string& help)
{
    const auto not_empty = [](const std::string& given) { return given.empty() ? "nothing given" : ""; };
    app_->add_option(name, word, help)
        ->type_name(kind)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
        ->check(not_empty);
}

void Command::add_repeated(const std::string& name, std::vector<std::string>& words, const std::string& kind,
                           const std::string& help)
{
    app_->add_option(name, words, help)
        ->type_name(kind)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->expected(1)
        ->allow_extra_args(false);
}

void Command::add_flag(const std::string& name, bool& flag, const std::string& help)
{
    app_->add_flag(name, flag, help);
}

bool Command::parsed() const
{
    return app_->parsed();
}

CommandLine::CommandLine(const Introduction& introduction)
    : app_(std::make_unique<CLI::App>(introduction.about, introduction.name))
{
    app_->set_version_flag("--version", introduction.version);
    app_->require_subcommand(1);
    app_->footer(introduction.footer);
}

CommandLine::~CommandLine() = default;

std::optional<std::string> CommandLine::parse(int count, const char* const* words)
{
    try {
        app_->parse(count, words);
    } catch (const CLI::CallForHelp&) {
        return app_->help();
    } catch (const CLI::CallForAllHelp&) {
        return app_->help("", CLI::AppFormatMode::All);
    } catch (const CLI::CallForVersion& version) {
        return text(version.what(), "\n");
    } catch (const CLI::ParseError& error) {
        if (count > 1 && words[1][0] != '-' && !knows_command(*app_, words[1]))
            throw Error(Failure::usage,
                        text("there is no command '", words[1], "'; lambent --help lists them"));
        throw Error(Failure::usage, first_line(error.what()));
    }
    return std::nullopt;
}

} // namespace lambent::cli
