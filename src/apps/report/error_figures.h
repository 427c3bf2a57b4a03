// Figures of errors, measured against references.
#pragma once

#include "apps/report/report_context.h"

namespace lambent::report {

/// A row for each entry of the context, which must have come before.
FigureBody error_table(ReportContext& context, const FigureData& figure);

/// The heat map of each entry of the context, which must have come before.
FigureBody heat_maps(ReportContext& context, const FigureData& figure);

/// What each of the report's approximations costs, apart from the others: a row for each of the reflecting sphere's
/// exponents.
FigureBody approximation_costs(ReportContext& context, const FigureData& figure);

/// Error without the reference's noise, by number of samples.
FigureBody convergence_plot(ReportContext& context, const FigureData& figure);

} // namespace lambent::report
