// The numbers under pictures, by the names that figures/*.json know them by.
#pragma once

#include "apps/report/report_context.h"

#include <optional>
#include <string>

namespace lambent::report {

/// A shot among those of its figure.
struct MeasuredShot {
    const FigureData& figure;
    const Values& values; ///< of the axes
    const Shot& shot;
};

bool is_quantity(const std::string& name);

/// The quantity as the page shows it, or nothing where there is nothing to say. Throws std::logic_error for an unknown
/// quantity.
std::optional<std::string> measured(ReportContext& context, const std::string& quantity,
                                    const MeasuredShot& shot);

/// Adds each of the figure's measurements whose condition the shot fits.
void add_measurements(ReportContext& context, const MeasuredShot& shot, PagePicture& picture);

} // namespace lambent::report
