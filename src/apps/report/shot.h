// The words of a shot's command, and numbers as the page shows them.
#pragma once

#include "apps/options/arguments.h"
#include "apps/report/content/figure_data.h"

#include <optional>
#include <string>
#include <vector>

namespace lambent::report {

using Words = std::vector<std::string>;

/// A command as typed in a shell: words with special characters are quoted.
std::string typed(const Words& words);

/// Parses the words as arguments of `lambent render`. Throws Error(usage).
cli::RenderArguments parse_render(Words words);

/// Parses the words as arguments of `lambent reference`. Throws Error(usage).
cli::ReferenceArguments parse_reference(Words words);

/// The words without display options: they identify the radiance. With --pipeline all words are kept.
Words without_display(const Words& words);

/// The words without the options of approximations, which the path tracer does not have.
Words without_approximations(const Words& words);

/// A share as "1.3 %": two significant digits, three from 10 % on.
std::string percent(double share);

/// A number with `digits` significant digits; below 0.0001 with an exponent and one digit fewer. "-" if not finite.
std::string rounded(double value, int digits = 3);

/// A share as "1.2 %", or "not known".
std::string noise_text(const std::optional<double>& noise);

} // namespace lambent::report
