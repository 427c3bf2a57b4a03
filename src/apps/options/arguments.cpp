#include "apps/options/arguments.h"

#include "apps/options/command_line.h"
#include "apps/options/option_table.h"
#include "apps/options/rules.h"
#include "base/error.h"
#include "base/text.h"
#include "base/version.h"

#include <array>
#include <optional>
#include <utility>

namespace lambent::cli {
namespace {

const char* const about =
    "Physically based and image based lighting: pictures of models under the light of real places.";
const char* const footer =
    "SCENE: a .gltf or .glb file, or sphere, teapot, plane, report, painted, grid, furnace.\n"
    "'lambent help COMMAND' lists a command's options, which follow it.";

constexpr std::array command_rows = {
    CommandRow{"render", command::render, "Draw a picture of a scene"},
    CommandRow{"bake", command::bake, "Prefilter an environment for other renderers"},
    CommandRow{"reference", command::reference, "Path-trace the same picture"},
    CommandRow{"compare", command::compare, "Measure how far a picture is from another"},
    CommandRow{"report", command::report, "Draw the 2014 report's figures and more, as one page"},
    CommandRow{"view", command::view, "Show a scene in a window, to turn and light it"},
    CommandRow{"serve", command::serve, "Show a scene in browsers, to turn and light it"},
    CommandRow{"env", command::env, "Write a built-in environment"},
    CommandRow{"info", command::info, "Describe a glTF or an image"}};

template <class Arguments>
void add_lists(std::vector<OptionList>& lists)
{
    for (const Group<Arguments>& group : groups<Arguments>()) {
        lists.push_back({group.heading, group.commands, {}});
        for (const Row<Arguments>& row : group.rows)
            lists.back().options.push_back(&row.option);
    }
}

Command add_command(Command program, const CommandRow& row, Given& given)
{
    Command added = program.add_subcommand(std::string(row.name), std::string(row.help));
    for (const OptionList& list : option_lists())
        if ((list.commands & row.bit) != 0)
            for (const Option* option : list.options)
                added.add(*option, list.heading, given);
    return added;
}

// Parses the words of each option, without the rules between options.
template <class Arguments>
Arguments taken(const Given& given, unsigned command)
{
    Arguments arguments;
    if constexpr (requires { arguments.common; }) {
        take(given, command, arguments.common);
        settle(arguments.common, given);
    }
    take(given, command, arguments);
    return arguments;
}

template <class Arguments>
Arguments settled(Arguments arguments, const Given& given)
{
    settle(arguments, given);
    return arguments;
}

ReferenceArguments reference_arguments(const Given& given)
{
    auto arguments = taken<ReferenceArguments>(given, command::reference);
    arguments.picture = taken<RenderArguments>(given, command::reference);
    return settled(std::move(arguments), given);
}

StartArguments start_arguments(const Given& given, unsigned command)
{
    return settled(StartArguments{taken<RenderArguments>(given, command), {}}, given);
}

Arguments arguments_of(unsigned command, const Given& given, std::vector<std::string> words)
{
    switch (command) {
    case command::render:
        return settled(taken<RenderArguments>(given, command), given);
    case command::bake:
        return settled(taken<BakeArguments>(given, command), given);
    case command::reference:
        return reference_arguments(given);
    case command::compare:
        return settled(taken<CompareArguments>(given, command), given);
    case command::report:
        return settled(taken<ReportArguments>(given, command), given);
    case command::view:
        return ViewArguments{start_arguments(given, command), std::move(words)};
    case command::serve: {
        auto arguments = taken<ServeArguments>(given, command);
        arguments.start = start_arguments(given, command);
        return arguments;
    }
    case command::env:
        return taken<EnvArguments>(given, command);
    default:
        return taken<InfoArguments>(given, command);
    }
}

} // namespace

std::span<const CommandRow> commands()
{
    return command_rows;
}

const std::vector<OptionList>& option_lists()
{
    static const std::vector<OptionList> all = [] {
        std::vector<OptionList> lists;
        add_lists<RenderArguments>(lists);
        add_lists<ReferenceArguments>(lists);
        add_lists<BakeArguments>(lists);
        add_lists<CompareArguments>(lists);
        add_lists<ReportArguments>(lists);
        add_lists<ServeArguments>(lists);
        add_lists<EnvArguments>(lists);
        add_lists<InfoArguments>(lists);
        add_lists<CommonOptions>(lists);
        return lists;
    }();
    return all;
}

void append(std::vector<std::string>& line, const OptionWord& word)
{
    const std::string name = dashed(*word.option);
    if (word.option->form == Form::positional)
        line.push_back(word.word);
    else if (word.option->form == Form::joined)
        line.push_back(text(name, "=", word.word));
    else if (word.option->domain.kind == Domain::Kind::flag)
        line.push_back(name);
    else
        line.insert(line.end(), {name, word.word});
}

Arguments parse_arguments(int count, const char* const* words)
{
    if (count < 2)
        throw Error(Failure::usage, "no command given; lambent --help lists them");
    CommandLine line({"lambent", about, text("lambent ", version), footer});
    Given given;
    std::vector<Command> added;
    added.reserve(command_rows.size());
    for (const CommandRow& row : command_rows)
        added.push_back(add_command(line.program(), row, given));
    if (const std::optional<std::string> asked_for = line.parse(count, words))
        return PrintText{*asked_for};
    std::size_t i = 0;
    while (!added.at(i).parsed())
        ++i;
    return arguments_of(command_rows.at(i).bit, given, {words, words + count});
}

} // namespace lambent::cli
