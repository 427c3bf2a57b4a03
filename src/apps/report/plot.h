// Curves on logarithmic axes as inline SVG.
#pragma once

#include "apps/report/page.h"

#include <string>
#include <vector>

namespace lambent::report {

/// A logarithmic axis over whole numbers of decades, or from 1, 2 or 5 of one to 1, 2 or 5 of another.
struct LogAxis {
    double least = 1, most = 10;

    /// 0 at `least`, 1 at `most`.
    double position(double value) const;
};

/// The axis that holds all values which are above 0 and finite.
LogAxis axis_of(const std::vector<double>& values);

struct Tick {
    double value;
    std::string label;     ///< empty: a line only
    bool is_decade = true; ///< a stronger line
};

/// No more labels than about `room`.
std::vector<Tick> ticks_of(const LogAxis& axis, int room);

/// Legend, and the drawing in a wide and in a narrow form, of which one is always hidden.
std::string plot_html(const Plot& plot);

/// One row for each place on the x axis, one column for each curve.
Table plotted_numbers(const Plot& plot);

} // namespace lambent::report
