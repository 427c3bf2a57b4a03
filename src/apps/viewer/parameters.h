// The parameters that can be set in a viewer: the rows of the table of options that have a control.
#pragma once

#include "apps/options/option_table.h"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lambent::viewer {

using Parameter = cli::Row<cli::RenderArguments>;

/// All parameters, in the order of the controls.
std::span<const Parameter* const> parameters();

/// The type of a control.
enum class Kind {
    number, ///< from least to most
    whole,  ///< an integer from least to most
    choice, ///< one of choices_of()
    color,  ///< "R,G,B", each from least to most
};
Kind kind_of(const Parameter& row);

/// The words to choose from; for a background only some of the possible ones.
std::vector<std::string> choices_of(const Parameter& row);

/// The value of a parameter as a word; empty: not given. Throws Error(usage) if there is no such parameter.
std::string value_of(const cli::RenderArguments& arguments, std::string_view name);

/// The value of a parameter that is a number.
double number_in(const cli::RenderArguments& arguments, std::string_view name);

/// Sets a parameter; numbers are rounded to six digits, and an empty word unsets an optional parameter. Throws
/// Error(usage) with one line if there is no such parameter or its control cannot be set to the word.
void set_value(cli::RenderArguments& arguments, std::string_view name, const std::string& word);

/// Sets a number to `value`, clamped to the range of its control.
void set_nearest(cli::RenderArguments& arguments, std::string_view name, double value);

/// The parameters with ranges and defaults, for the page: an array of objects.
nlohmann::ordered_json to_json(std::span<const Parameter* const> rows);

/// The values of all parameters, for the page: an object of words.
nlohmann::ordered_json to_json(const cli::RenderArguments& arguments);

using cli::number_word;

/// A coordinate as a word, with an absolute precision of six digits of `scale`, or six digits of its own if those are
/// more precise; at most 15 digits.
std::string place_word(double value, double scale);

} // namespace lambent::viewer
