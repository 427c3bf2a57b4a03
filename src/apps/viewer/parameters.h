// What can be set about a picture while it is looked at: the rows of the table of options that have a control.
#pragma once

#include "apps/options/option_table.h"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lambent::viewer {

using Parameter = cli::Row<cli::RenderArguments>;

/// In the order of the controls.
std::span<const Parameter* const> parameters();

/// What a control looks like.
enum class Kind {
    number, ///< from least to most
    whole,  ///< the same without fractions
    choice, ///< one of choices_of()
    color,  ///< "R,G,B", each from least to most
};
Kind kind_of(const Parameter& row);

/// The words to choose from; of a background a few of what there may be.
std::vector<std::string> choices_of(const Parameter& row);

/// The word of a parameter; empty: not given. Throws Error(usage) if there is no such parameter.
std::string value_of(const cli::RenderArguments& arguments, std::string_view name);

/// The same of one that is a number.
double number_in(const cli::RenderArguments& arguments, std::string_view name);

/// Numbers are kept to six digits; an empty word takes back what need not be given. Throws Error(usage) with one line if there
/// is no such parameter or the word is none that its control can be set to.
void set_value(cli::RenderArguments& arguments, std::string_view name, const std::string& word);

/// The number that the control can be set to which is nearest to `value`.
void set_nearest(cli::RenderArguments& arguments, std::string_view name, double value);

/// The table with its defaults, for pages: an array of objects.
nlohmann::ordered_json to_json(std::span<const Parameter* const> rows);

/// The values, for pages: an object of words.
nlohmann::ordered_json to_json(const cli::RenderArguments& arguments);

using cli::number_word;

/// The same of a coordinate, to six digits of `scale` where that is less: as many as tell places that far apart.
std::string place_word(double value, double scale);

} // namespace lambent::viewer
