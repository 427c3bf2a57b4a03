// The table of options. Its rows contain everything about an option.
#pragma once

#include "apps/options/arguments.h"
#include "apps/options/option_value.h"

#include <string>
#include <utility>
#include <vector>

namespace lambent::cli {

/// The rows whose values are members of `Arguments`.
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

/// Calls visit(row) for the rows of `commands` whose values are members of `Arguments`.
template <class Arguments, class Visit>
void for_each_row(unsigned commands, Visit&& visit)
{
    for (const Group<Arguments>& group : groups<Arguments>())
        if ((group.commands & commands) != 0)
            for (const Row<Arguments>& row : group.rows)
                visit(row);
}

/// Whether an option has an effect with the scene and the shading model of `arguments`.
bool applies(Needs needs, const RenderArguments& arguments);

/// Throws Error(usage) if the option has no effect.
void check_needs(const Option& option, const RenderArguments& arguments);
template <class Arguments>
void check_needs(const Option&, const Arguments&)
{
}

/// Sets the values that a command line gives. Throws Error(usage).
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

/// The options that differ from their defaults, as words from which the command gets the same arguments. An option that
/// may be repeated appears once for each of its words.
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

/// Appends an option with its word to a command line.
void append(std::vector<std::string>& line, const OptionWord& word);

} // namespace lambent::cli
