#include "apps/report/own_tables.h"

#include "compare/appearance.h"

namespace lambent::report {
namespace {

// A shot of the figure that shots_of names at an index.
Shot other_shot(const ReportContext& context, const FigureData& figure, std::size_t index,
                const Values& values)
{
    return shot_of(context.content, context.content.figure(figure.shots_of.at(index)), values);
}

} // namespace

FigureBody sky_numbers(ReportContext& context, const FigureData& figure)
{
    Table table{figure.titles, {}};
    for (const std::string& exposure : figure.rows.values) {
        const auto look = [&](const char* way) {
            return compare::look_of(context.renderer.codes(
                other_shot(context, figure, 0, {{"way", way}, {"exposure", exposure}})));
        };
        const compare::Look report = look("report"), light = look("light");
        table.rows.push_back({exposure, percent(report.mean), percent(report.saturation),
                              percent(report.blank), percent(report.black), percent(light.mean)});
    }
    return table;
}

FigureBody texel_scales(ReportContext& context, const FigureData& figure)
{
    Table table{figure.titles, {}};
    for (const std::string& scale : figure.rows.values) {
        const auto look = [&](const char* exposure) {
            const Values values = {{"way", "report"}, {"exposure", exposure}, {figure.rows.name, scale}};
            return compare::look_of(context.renderer.codes(other_shot(context, figure, 0, values)));
        };
        const compare::Look well = look("70");
        table.rows.push_back({scale, percent(look("7000").blank), percent(1.0 - well.blank - well.black),
                              percent(look("1").blank)});
    }
    return table;
}

FigureBody order_costs(ReportContext& context, const FigureData& figure)
{
    Table table{figure.titles, {}};
    for (const std::string& exposure : figure.rows.values) {
        const auto other = [&](std::size_t index, const char* way) {
            return other_shot(context, figure, index, {{"way", way}, {"exposure", exposure}});
        };
        // Nonlinear colour with the tone curve last.
        const Shot curve_last = shot_of(context.content, figure, {{"exposure", exposure}});
        table.rows.push_back(
            {exposure, percent(code_difference(context.renderer, other(0, "report"), other(0, "light"))),
             percent(code_difference(context.renderer, other(1, "nonlinear"), curve_last))});
    }
    return table;
}

FigureBody density_costs(ReportContext& context, const FigureData& figure)
{
    Table table{figure.titles, {}};
    for (const Values& values : axis_values(figure)) {
        const Shot white = shot_of(context.content, figure, values);
        const double mean = mean_on_surfaces(context.renderer.frame(white).radiance),
                     exact = mean_on_surfaces(context.renderer.reference(white).radiance);
        table.rows.push_back(
            {values.at(figure.rows.name), percent(mean), percent(exact), percent(mean / exact)});
    }
    return table;
}

FigureBody saturations(ReportContext& context, const FigureData& figure)
{
    Table table{figure.titles, {}};
    for (const std::string& exposure : figure.rows.values) {
        const auto in_space = [&](const char* space) {
            return saturation(context.renderer,
                              other_shot(context, figure, 0, {{"space", space}, {"exposure", exposure}}));
        };
        const double linear = in_space("linear"), nonlinear = in_space("nonlinear");
        table.rows.push_back({exposure, percent(linear), percent(nonlinear), rounded(linear / nonlinear)});
    }
    return table;
}

} // namespace lambent::report
