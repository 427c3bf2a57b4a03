// Curves on logarithmic axes as inline SVG.
#pragma once

#include "apps/report/page.h"

#include <string>
#include <vector>

namespace lambent::report {

/// A logarithmic axis whose ends are 1, 2 or 5 times powers of ten.
struct LogAxis {
    double least = 1, most = 10;

    /// 0 at `least`, 1 at `most`.
    double position(double value) const;
};

/// The shortest axis that contains all finite values above 0; 1 to 10 without any.
LogAxis axis_of(const std::vector<double>& values);

struct Tick {
    double value;
    std::string label;     ///< empty: a line only
    bool is_decade = true; ///< a stronger line
};

/// The ticks of an axis, about `room` of which at most have labels.
std::vector<Tick> ticks_of(const LogAxis& axis, int room);

/// The legend, and a drawing each for wide and for narrow pages, one of which the style hides.
std::string plot_html(const Plot& plot);

/// The curves as a table: one row for each value of x, one column for each curve.
Table plotted_numbers(const Plot& plot);

} // namespace lambent::report
