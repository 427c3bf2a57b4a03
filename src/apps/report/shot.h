// The words of a shot's command, and numbers as the page shows them.
#pragma once

#include "apps/options/arguments.h"
#include "apps/report/content/figure_data.h"

#include <optional>
#include <string>
#include <vector>

namespace lambent::report {

using Words = std::vector<std::string>;

/// A command as it is typed: words with anything special in them in quotes.
std::string typed(const Words& words);

/// What the words ask for. Throws Error(usage).
cli::RenderArguments parse_render(Words words);

/// Likewise of `lambent reference`.
cli::ReferenceArguments parse_reference(Words words);

/// The words without the options that only say how light is shown. What is left names the light.
Words without_display(const Words& words);

/// The words without the options that only say how to approximate: the path tracer has no use for them.
Words without_approximations(const Words& words);

/// "1.3 %", two digits or, from 10 % on, whole.
std::string percent(double share);

/// A number with `digits` significant digits; below 0.0001 with an exponent and one less.
std::string rounded(double value, int digits = 3);

/// A share as "1.2 %", or "not known".
std::string noise_text(const std::optional<double>& noise);

} // namespace lambent::report
