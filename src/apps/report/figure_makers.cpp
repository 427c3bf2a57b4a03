#include "apps/report/figure_makers.h"

#include "apps/report/error_figures.h"
#include "apps/report/layer_figures.h"
#include "apps/report/measurements.h"
#include "apps/report/own_tables.h"
#include "apps/report/picture_figures.h"
#include "base/text.h"

#include <map>
#include <stdexcept>

namespace lambent::report {
namespace {

const std::map<std::string, FigureMaker> makers = {
    {"own-sky-numbers", sky_numbers},
    {"own-scale", texel_scales},
    {"own-order", order_costs},
    {"own-density", density_costs},
    {"diffuse-saturation", saturations},
    {"passes-buffer", layer_pictures},
    {"passes-light", layer_pictures},
    {"beyond-errors", error_table},
    {"beyond-heat", heat_maps},
    {"beyond-approximations", approximation_costs},
    {"beyond-convergence", convergence_plot},
};

} // namespace

FigureBody figure_body(ReportContext& context, const FigureData& figure)
{
    const auto found = makers.find(figure.id);
    return (found == makers.end() ? shot_pictures : found->second)(context, figure);
}

void check_makers(const Content& content)
{
    for (const auto& [id, maker] : makers)
        (void)content.figure(id);
    for (const auto& [id, figure] : content.figures()) {
        const bool drawn_by_itself = figure.kind != FigureKind::table && figure.kind != FigureKind::plot;
        if (!makers.contains(id) && !(drawn_by_itself && figure.shot))
            throw std::logic_error(text("no function makes the figure ", id));
        for (const Measurement& measurement : figure.measured)
            if (!is_quantity(measurement.quantity))
                throw std::logic_error(
                    text("the figure ", id, " measures an unknown quantity, \"", measurement.quantity, "\""));
    }
}

} // namespace lambent::report
