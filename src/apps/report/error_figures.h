// Figures of errors, measured against references.
#pragma once

#include "apps/report/report_context.h"

namespace lambent::report {

/// A row for each entry of the context. The pictures must have been drawn before.
FigureBody error_table(ReportContext& context, const FigureData& figure);

/// The heat map of each entry of the context. The pictures must have been drawn before.
FigureBody heat_maps(ReportContext& context, const FigureData& figure);

/// The error of each of the report's approximations on its own: a row for each exponent of the reflecting sphere.
FigureBody approximation_costs(ReportContext& context, const FigureData& figure);

/// Error without the reference's noise, by number of samples.
FigureBody convergence_plot(ReportContext& context, const FigureData& figure);

} // namespace lambent::report
