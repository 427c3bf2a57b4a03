// Figures of pictures that only their data tell apart.
#pragma once

#include "apps/report/report_context.h"

namespace lambent::report {

/// A gallery, a matrix or a comparison of the figure's shots, with what is measured in them and their references.
FigureBody shot_pictures(ReportContext& context, const FigureData& figure);

} // namespace lambent::report
