// Galleries, matrices and comparisons that are made from their data alone.
#pragma once

#include "apps/report/report_context.h"

namespace lambent::report {

/// A gallery, a matrix or a comparison of the figure's shots, with their measurements and references.
FigureBody shot_pictures(ReportContext& context, const FigureData& figure);

} // namespace lambent::report
