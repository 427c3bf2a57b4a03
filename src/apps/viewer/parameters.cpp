#include "apps/viewer/parameters.h"

#include "apps/options/values.h"
#include "base/error.h"
#include "base/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace lambent::viewer {
namespace {

using cli::Control, cli::Option, cli::RenderArguments;

std::vector<const Parameter*> rows_with_controls()
{
    std::vector<const Parameter*> rows;
    cli::for_each_row<RenderArguments>(cli::command::all | cli::command::viewers_alone,
                                       [&](const Parameter& row) {
                                           if (!row.option.control.label.empty())
                                               rows.push_back(&row);
                                       });
    std::ranges::sort(rows, {}, [](const Parameter* row) { return row->option.place; });
    return rows;
}

const Parameter& find(std::string_view name)
{
    for (const Parameter* row : parameters())
        if (row->option.name == name)
            return *row;
    throw Error(Failure::usage, text("there is no parameter '", name.substr(0, 40), "'"));
}

// Returns the option with its domain narrowed to what its control can be set to, so that the table of options checks
// words and gives its own messages.
Option narrowed(const Option& option)
{
    const Control& control = option.control;
    Option result = option;
    if (option.domain.kind == cli::Domain::Kind::choice) {
        if (!control.choices.empty())
            result.domain.choices = control.choices;
        return result;
    }
    result.domain.least = control.least;
    result.domain.most = control.most;
    result.domain.above_least = false;
    result.domain.choices = {};
    return result;
}

// A word of a choice as it may be repeated in a message: choices are shorter, so a longer word remains invalid.
std::string shortened(const std::string& word)
{
    return word.substr(0, 40);
}

std::string checked_choice(const Option& option, const std::string& word)
{
    if (option.domain.kind == cli::Domain::Kind::background)
        cli::parse_background(word, cli::dashed(option));
    else
        cli::choice_of(option, shortened(word));
    return word;
}

std::string checked_color(const Option& option, const std::string& word)
{
    const glm::vec3 color = cli::parse_color(word, cli::dashed(option));
    std::string result;
    for (int c = 0; c < 3; ++c) {
        const std::string channel = number_word(static_cast<double>(color[c]));
        cli::number_of(option, channel);
        result += text(c > 0 ? "," : "", channel);
    }
    return result;
}

// Returns the word as it is kept. Throws Error(usage) where the control cannot be set to it.
std::string checked(const Parameter& row, const std::string& word)
{
    if (word.empty() && row.option.usual.empty())
        return word;
    const Option option = narrowed(row.option);
    switch (kind_of(row)) {
    case Kind::choice:
        return checked_choice(option, word);
    case Kind::color:
        return checked_color(option, word);
    default:
        return number_word(cli::number_of(option, word));
    }
}

const char* name_of(Kind kind)
{
    constexpr std::array names = {"number", "whole", "choice", "color"};
    return names[static_cast<std::size_t>(kind)];
}

const char* name_of(cli::Needs needs)
{
    return needs == cli::Needs::ggx ? "ggx" : needs == cli::Needs::phong_shapes ? "phong_shapes" : "all";
}

} // namespace

std::span<const Parameter* const> parameters()
{
    static const std::vector<const Parameter*> rows = rows_with_controls();
    return rows;
}

Kind kind_of(const Parameter& row)
{
    using Domain = cli::Domain::Kind;
    switch (row.option.domain.kind) {
    case Domain::whole:
        return Kind::whole;
    case Domain::color:
        return Kind::color;
    case Domain::choice:
    case Domain::background:
        return Kind::choice;
    default:
        return Kind::number;
    }
}

std::vector<std::string> choices_of(const Parameter& row)
{
    const std::string_view few = row.option.control.choices;
    return cli::words_in(few.empty() ? row.option.domain.choices : few);
}

std::string value_of(const RenderArguments& arguments, std::string_view name)
{
    const Parameter& row = find(name);
    return row.value.get(arguments, row.option);
}

double number_in(const RenderArguments& arguments, std::string_view name)
{
    return std::stod(value_of(arguments, name));
}

void set_value(RenderArguments& arguments, std::string_view name, const std::string& word)
{
    const Parameter& row = find(name);
    row.value.set(arguments, row.option, checked(row, word));
}

void set_nearest(RenderArguments& arguments, std::string_view name, double value)
{
    const Control& control = find(name).option.control;
    set_value(arguments, name, number_word(std::clamp(value, control.least, control.most)));
}

nlohmann::ordered_json to_json(std::span<const Parameter* const> rows)
{
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Parameter* row : rows) {
        const Option& option = row->option;
        const Control& control = option.control;
        nlohmann::ordered_json entry = {{"name", option.name},           {"label", control.label},
                                        {"group", control.group},        {"kind", name_of(kind_of(*row))},
                                        {"usual", option.usual},         {"least", control.least},
                                        {"most", control.most},          {"logarithmic", control.logarithmic},
                                        {"scope", name_of(option.needs)}};
        if (kind_of(*row) == Kind::choice)
            entry["choices"] = choices_of(*row);
        list.push_back(std::move(entry));
    }
    return list;
}

nlohmann::ordered_json to_json(const RenderArguments& arguments)
{
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (const Parameter* row : parameters())
        object[std::string(row->option.name)] = row->value.get(arguments, row->option);
    return object;
}

std::string place_word(double value, double scale)
{
    const double more = std::log10(std::fabs(value) / scale);
    return cli::word_of_digits(value,
                               more > 0.0 ? static_cast<int>(std::min(6.0 + std::ceil(more), 15.0)) : 6);
}

} // namespace lambent::viewer
