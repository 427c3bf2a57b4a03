#include "apps/options/command_line.h"

#include "base/closest.h"
#include "base/error.h"
#include "base/text.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <sstream>
#include <string>

namespace lambent::cli {
namespace {

// Widths of the help in columns: of the names of options, and of whole lines, which must fit terminals of 80.
constexpr std::size_t names_width = 28, help_width = 80;

// Wraps text between words to lines of at most `width`; keeps its own line breaks.
std::string wrapped(const std::string& words, std::size_t width)
{
    std::string all, line;
    const auto end_line = [&] {
        all += line + "\n";
        line.clear();
    };
    std::istringstream lines(words);
    for (std::string given; std::getline(lines, given); end_line()) {
        std::istringstream stream(given);
        for (std::string word; stream >> word;) {
            if (!line.empty() && line.size() + 1 + word.size() > width)
                end_line();
            line += (line.empty() ? "" : " ") + word;
        }
    }
    return all;
}

std::string without_last_break(std::string lines)
{
    if (!lines.empty() && lines.back() == '\n')
        lines.pop_back();
    return lines;
}

class HelpFormatter : public CLI::Formatter {
public:
    HelpFormatter() { column_width(names_width); }

    std::string make_description(const CLI::App* app) const override
    {
        return wrapped(app->get_description(), help_width);
    }
    std::string make_footer(const CLI::App* app) const override
    {
        return wrapped(app->get_footer(), help_width);
    }
    std::string make_option_desc(const CLI::Option* option) const override
    {
        return without_last_break(wrapped(option->get_description(), help_width - names_width));
    }
    std::string make_subcommand(const CLI::App* command) const override
    {
        std::ostringstream line;
        CLI::detail::format_help(line, command->get_name(), command->get_description(), names_width);
        return line.str();
    }
};

std::vector<std::string> command_names(const CLI::App& app)
{
    std::vector<std::string> names = {"help"};
    for (const CLI::App* command : app.get_subcommands(nullptr))
        names.push_back(command->get_name());
    return names;
}

std::vector<std::string> option_names(const CLI::App& command)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    return names;
}

// Throws Error(usage) unless the first word is a command or asks for help or the version.
void check_first(const CLI::App& app, const std::string& word)
{
    const std::vector<std::string> names = command_names(app);
    if (std::find(names.begin(), names.end(), word) != names.end())
        return;
    if (!word.starts_with('-'))
        throw Error(Failure::usage, text("there is no command '", word, "'", did_you_mean(word, names),
                                         "; lambent --help lists them"));
    for (const char* alone : {"-h", "--help", "--version"})
        if (word == alone)
            return;
    throw Error(Failure::usage, text(word, ": options follow the command: lambent COMMAND ... ", word));
}

// Replaces `help [COMMAND]` by `[COMMAND] --help`.
std::vector<std::string> without_help_command(const CLI::App& app, std::vector<std::string> words)
{
    check_first(app, words[1]);
    if (words[1] != "help")
        return words;
    if (words.size() > 3)
        throw Error(Failure::usage, "help: one command at a time: lambent help COMMAND");
    if (words.size() == 2 || words[2] == "help")
        return {words[0], "--help"};
    check_first(app, words[2]);
    return {words[0], words[2], "--help"};
}

// Throws Error(usage) for the command's first unknown option, which CLI11 reports only after missing arguments.
void refuse_unknown_option(const CLI::App& app)
{
    for (const CLI::App* command : app.get_subcommands())
        for (const std::string& word : command->remaining())
            if (const std::string name = word.substr(0, word.find('=')); name.starts_with("--"))
                throw Error(Failure::usage, text(command->get_name(), ": there is no option '", name, "'",
                                                 did_you_mean(name, option_names(*command)),
                                                 "; lambent help ", command->get_name(), " lists them"));
}

// The first line of a message; CLI11's may have several.
std::string first_line(const std::string& message)
{
    return message.substr(0, message.find('\n'));
}

} // namespace

Command Command::add_subcommand(const std::string& name, const std::string& help)
{
    CLI::App* const command = app_->add_subcommand(name, help);
    command->get_help_ptr()->group("Everywhere")->description("Print this help");
    return Command(*command);
}

void Command::add(const Option& option, std::string_view heading, Given& given)
{
    const std::string name = option.form == Form::positional ? std::string(option.name)
                             : option.letter != 0            ? text("-", option.letter, ",", dashed(option))
                                                             : dashed(option);
    const auto take = [&](const std::vector<std::string>& words) {
        for (const std::string& word : words)
            if (!word.empty() || option.form == Form::repeated)
                given.add(option.name, word);
    };
    CLI::Option* const added =
        option.domain.kind == Domain::Kind::flag ? app_->add_flag_callback(
                                                       name, [take] { take({"yes"}); }, help_of(option))
        : option.form == Form::repeated
            ? app_->add_option_function<std::vector<std::string>>(name, take, help_of(option))
            : app_->add_option_function<std::string>(
                  name, [take](const std::string& word) { take({word}); }, help_of(option));
    added->group(std::string(heading));
    if (option.domain.kind == Domain::Kind::flag)
        return;
    added->type_name(std::string(option.word));
    if (option.form == Form::repeated)
        added->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)->expected(1)->allow_extra_args(false);
    else if (option.form == Form::required || option.form == Form::positional)
        added->required();
    else
        added->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)->check([](const std::string& word) {
            return word.empty() ? "the value is empty" : "";
        });
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
    app_->formatter(std::make_shared<HelpFormatter>());
}

CommandLine::~CommandLine() = default;

std::optional<std::string> CommandLine::parse(int count, const char* const* words)
{
    const std::vector<std::string> given = without_help_command(*app_, {words, words + count});
    try {
        // CLI11 takes the words in reverse order, without the program's name.
        app_->parse(std::vector<std::string>(given.rbegin(), given.rend() - 1));
    } catch (const CLI::CallForHelp&) {
        return app_->help();
    } catch (const CLI::CallForVersion& version) {
        return text(version.what(), "\n");
    } catch (const CLI::ParseError& error) {
        refuse_unknown_option(*app_);
        throw Error(Failure::usage, first_line(error.what()));
    }
    return std::nullopt;
}

} // namespace lambent::cli
