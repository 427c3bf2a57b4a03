// The layers of a frame as pictures: G-buffer and passes.
#pragma once

#include "apps/report/report_context.h"

namespace lambent::report {

/// A picture for each layer that the figure names; the layer "sum" is the shot itself.
FigureBody layer_pictures(ReportContext& context, const FigureData& figure);

/// The largest difference between a value of the picture and the sum of its passes, relative above 1.
double worst_difference(const draw::Frame& frame);

} // namespace lambent::report
