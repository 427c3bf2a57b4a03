// Tables of measurements: of the report's own pipeline and of its colour spaces.
#pragma once

#include "apps/report/report_context.h"

namespace lambent::report {

/// The look of the report's sky at each exposure.
FigureBody sky_numbers(ReportContext& context, const FigureData& figure);

/// The numbers that decide the scale of texels, for each scale: the report's captions ask for three of four pixels
/// blank at 7000, most neither blank nor near black at 70, and none blank at 1.
FigureBody texel_scales(ReportContext& context, const FigureData& figure);

/// The differences that the power of 2.2 and the position of the tone curve make, at each exposure.
FigureBody order_costs(ReportContext& context, const FigureData& figure);

/// The share of white light that a white sphere reflects, at each exponent: by the mean of samples without density, and
/// by the integral.
FigureBody density_costs(ReportContext& context, const FigureData& figure);

/// The saturation in linear and nonlinear colour, at each exposure.
FigureBody saturations(ReportContext& context, const FigureData& figure);

} // namespace lambent::report
