#include "apps/report/error_figures.h"

#include "base/text.h"
#include "compare/brightness_fit.h"
#include "compare/difference.h"

#include <algorithm>

namespace lambent::report {
namespace {

// The mean share of a white environment that a white specular sphere reflects, path-traced: 1 if none is lost.
double kept_energy(ReportContext& context, const FigureData& figure, const Values& values)
{
    const Shot white = shot_of(context.content, figure, values);
    return mean_on_surfaces(context.renderer.reference(white).radiance);
}

Curve convergence(ShotRenderer& renderer, const std::string& name, const Shot& shot,
                  const std::vector<std::string>& numbers)
{
    Curve curve{name, {}, {}};
    const image::RadianceImage exact = clamped_light(renderer.reference(shot).radiance);
    const std::optional<double> noise = clamped_noise(renderer.reference(shot));
    for (const std::string& samples : numbers) {
        Shot sampled = shot;
        sampled.words += text(" --samples ", samples);
        const image::RadianceImage drawn = clamped_light(renderer.frame(sampled).radiance);
        const double error = compare::difference({drawn, exact}, light_clamp).relative_rmse;
        curve.x.push_back(std::stod(samples));
        curve.y.push_back(std::max(1e-3, without_noise(error, noise)));
    }
    return curve;
}

} // namespace

FigureBody error_table(ReportContext& context, const FigureData& figure)
{
    Table table{figure.titles, {}};
    for (const Entry& entry : context.entries)
        table.rows.push_back({entry.figure, percent(entry.comparison.error),
                              noise_text(entry.comparison.noise),
                              percent(without_noise(entry.comparison.error, entry.comparison.noise)),
                              rounded(entry.comparison.flip)});
    return table;
}

FigureBody heat_maps(ReportContext& context, const FigureData&)
{
    Gallery gallery;
    for (const Entry& entry : context.entries) {
        PagePicture picture = entry.comparison.heat;
        picture.title = entry.figure;
        picture.numbers = {{context.content.label("error"), percent(entry.comparison.error)},
                           {context.content.label("flip"), rounded(entry.comparison.flip)}};
        gallery.pictures.push_back(std::move(picture));
    }
    return gallery;
}

FigureBody approximation_costs(ReportContext& context, const FigureData& figure)
{
    ShotRenderer& renderer = context.renderer;
    const FigureData& spheres = context.content.figure(figure.shots_of.at(0));
    Table table{figure.titles, {}};
    for (const std::string& exponent : figure.rows.values) {
        const Values at_levels[] = {{{"exponent", exponent}, {"levels", "report"}},
                                    {{"exponent", exponent}, {"levels", "matched"}}};
        const Shot report = shot_of(context.content, spheres, at_levels[0]),
                   matched = shot_of(context.content, spheres, at_levels[1]),
                   many_samples = converged_shot_of(context.content, spheres, at_levels[1]);
        const std::optional<double> noise = clamped_noise(renderer.reference(matched));
        const image::RadianceImage exact = clamped_light(renderer.reference(matched).radiance),
                                   converged = clamped_light(renderer.frame(many_samples).radiance);
        const auto error = [&](const Shot& shot) {
            return compare::brightness_fit({clamped_light(renderer.frame(shot).radiance), converged}).error;
        };
        const compare::BrightnessFit lobe = compare::brightness_fit({converged, exact});
        table.rows.push_back({exponent, percent(error(report)), percent(error(matched)),
                              percent(without_noise(lobe.error, noise)), rounded(lobe.factor),
                              percent(without_noise(lobe.left, noise)),
                              percent(kept_energy(context, figure, {{"exponent", exponent}}))});
    }
    return table;
}

FigureBody convergence_plot(ReportContext& context, const FigureData& figure)
{
    Plot plot{figure.titles.at(0), figure.titles.at(1), figure.alt, {}};
    for (const PlottedCurve& curve : figure.curves) {
        const Shot shot = shot_of(context.content, context.content.figure(curve.figure), curve.values);
        plot.curves.push_back(convergence(context.renderer, curve.name, shot, figure.rows.values));
    }
    return plot;
}

} // namespace lambent::report
