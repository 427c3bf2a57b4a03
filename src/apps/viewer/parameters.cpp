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

void check_range(const Option& option, double value)
{
    const Control& control = option.control;
    if (value < control.least || value > control.most)
        throw Error(Failure::usage,
                    text(option.name, ": ", value, " is not from ", control.least, " to ", control.most));
}

std::string checked_choice(const Parameter& row, const std::string& word)
{
    const Option& option = row.option;
    if (option.domain.kind == cli::Domain::Kind::background) {
        cli::parse_background(word, std::string(option.name));
        return word;
    }
    const std::vector<std::string> words = choices_of(row);
    if (std::find(words.begin(), words.end(), word) == words.end())
        throw Error(Failure::usage,
                    text(option.name, ": '", word.substr(0, 40), "' is none of ", option.domain.choices));
    return word;
}

std::string checked_color(const Option& option, const std::string& word)
{
    const glm::vec3 color = cli::parse_color(word, std::string(option.name));
    for (int c = 0; c < 3; ++c)
        check_range(option, static_cast<double>(color[c]));
    return text(number_word(static_cast<double>(color.r)), ",", number_word(static_cast<double>(color.g)),
                ",", number_word(static_cast<double>(color.b)));
}

std::string checked_number(const Parameter& row, const std::string& word)
{
    const double value = cli::parse_number(word, std::string(row.option.name));
    check_range(row.option, value);
    if (kind_of(row) == Kind::whole && value != std::floor(value))
        throw Error(Failure::usage, text(row.option.name, ": ", value, " is not a whole number"));
    return number_word(value);
}

std::string checked(const Parameter& row, const std::string& word)
{
    if (word.empty() && row.option.usual.empty())
        return word;
    switch (kind_of(row)) {
    case Kind::choice:
        return checked_choice(row, word);
    case Kind::color:
        return checked_color(row.option, word);
    default:
        return checked_number(row, word);
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
