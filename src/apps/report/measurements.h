// The quantities that figures/*.json can name.
#pragma once

#include "apps/report/report_context.h"

#include <optional>
#include <string>

namespace lambent::report {

/// A shot and its figure.
struct MeasuredShot {
    const FigureData& figure;
    const Values& values; ///< of the axes
    const Shot& shot;
};

bool is_quantity(const std::string& name);

/// The quantity as text for the page; empty where the page should not show it. Throws std::logic_error for an unknown
/// quantity.
std::optional<std::string> measured(ReportContext& context, const std::string& quantity,
                                    const MeasuredShot& shot);

/// Adds those of the figure's measurements whose condition holds for the shot.
void add_measurements(ReportContext& context, const MeasuredShot& shot, PagePicture& picture);

} // namespace lambent::report
