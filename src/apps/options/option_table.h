// The table of options: everything about an option is in its row.
#pragma once

#include "apps/options/arguments.h"
#include "apps/options/option_value.h"

#include <string>
#include <utility>
#include <vector>

namespace lambent::cli {

/// The rows whose values are in such arguments.
template <class Arguments>
const std::vector<Group<Arguments>>& groups();

template <>
const std::vector<Group<RenderArguments>>& groups<RenderArguments>();
template <>
const std::vector<Group<ReferenceArguments>>& groups<ReferenceArguments>();
template <>
const std::vector<Group<BakeArguments>>& groups<BakeArguments>();
template <>
const std::vector<Group<CompareArguments>>& groups<CompareArguments>();
template <>
const std::vector<Group<ReportArguments>>& groups<ReportArguments>();
template <>
const std::vector<Group<ServeArguments>>& groups<ServeArguments>();
template <>
const std::vector<Group<EnvArguments>>& groups<EnvArguments>();
template <>
const std::vector<Group<InfoArguments>>& groups<InfoArguments>();
template <>
const std::vector<Group<CommonOptions>>& groups<CommonOptions>();

/// Calls visit(row) for the rows of a command whose values are in such arguments.
template <class Arguments, class Visit>
void for_each_row(unsigned commands, Visit&& visit)
{
    for (const Group<Arguments>& group : groups<Arguments>())
        if ((group.commands & commands) != 0)
            for (const Row<Arguments>& row : group.rows)
                visit(row);
}

/// Whether an option says something of such a picture: of the scene and the model.
bool applies(Needs needs, const RenderArguments& arguments);

/// Throws Error(usage) where it does not.
void check_needs(const Option& option, const RenderArguments& arguments);
template <class Arguments>
void check_needs(const Option&, const Arguments&)
{
}

/// Sets what the words of a command line say. Throws Error(usage).
template <class Arguments>
void take(const Given& given, unsigned command, Arguments& arguments)
{
    for_each_row<Arguments>(command, [&](const Row<Arguments>& row) {
        for (const std::string& word : given.words(row.option.name)) {
            check_needs(row.option, arguments);
            row.value.set(arguments, row.option, word);
        }
    });
}

/// An option with its word.
struct OptionWord {
    const Option* option;
    std::string word;
};

/// The words from which a command takes the same arguments: of options that differ from their defaults. Those that may be
/// repeated have one word each.
template <class Arguments>
std::vector<OptionWord> words_of(const Arguments& arguments, unsigned command)
{
    std::vector<OptionWord> words;
    for_each_row<Arguments>(command, [&](const Row<Arguments>& row) {
        const std::string word = row.value.get(arguments, row.option);
        if (word.empty() || word == row.option.usual)
            return;
        if (row.option.form != Form::repeated)
            words.push_back({&row.option, word});
        else
            for (const std::string& one : words_in(word))
                words.push_back({&row.option, one});
    });
    return words;
}

/// The same as a command line has them.
void append(std::vector<std::string>& line, const OptionWord& word);

} // namespace lambent::cli
