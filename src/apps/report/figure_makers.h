// The functions that make those figures for which the data alone are not enough.
#pragma once

#include "apps/report/report_context.h"

#include <string>

namespace lambent::report {

using FigureMaker = FigureBody (*)(ReportContext&, const FigureData&);

/// Makes what the figure shows.
FigureBody figure_body(ReportContext& context, const FigureData& figure);

/// Throws std::logic_error unless there is a function for each table and each plot, a figure for each function, and
/// every quantity that figures measure is known.
void check_makers(const Content& content);

} // namespace lambent::report
