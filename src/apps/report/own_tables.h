// Tables of what is measured in shots: of the report's own pipeline, and of its colour spaces.
#pragma once

#include "apps/report/report_context.h"

namespace lambent::report {

/// How the report's sky looks at each exposure.
FigureBody sky_numbers(ReportContext& context, const FigureData& figure);

/// What the report's captions ask of the brightness of texels, at each factor on it: three of four pixels blank at
/// 7000, most of them neither blank nor near black at 70, and none blank at 1.
FigureBody texel_scales(ReportContext& context, const FigureData& figure);

/// What the power of 2.2 and the place of the tone curve change, at each exposure.
FigureBody order_costs(ReportContext& context, const FigureData& figure);

/// What a white sphere reflects of white light, at each exponent: the mean of samples without density, and the
/// integral.
FigureBody density_costs(ReportContext& context, const FigureData& figure);

/// The saturation in linear and nonlinear colour, at each exposure.
FigureBody saturations(ReportContext& context, const FigureData& figure);

} // namespace lambent::report
