#include "apps/report/report_context.h"
#include "apps/report/approximations.h"
#include "base/text.h"
#include "compare/appearance.h"
#include "compare/difference.h"

#include <algorithm>
#include <cmath>

namespace lambent::report {
namespace {

const char* const tones[] = {"reinhard", "neutral", "aces", "agx", "linear"};

const std::string reflecting_view = " --camera 240,14,2.6 --fov 34";

Shot toned(const std::string& curve)
{
    return {"tone-" + curve, "painted" + reflecting_view + " --exposure 1.5 --tone " + curve, curve,
            "A chart of colours on a sphere through the tone curve " + curve};
}

Shot modelled(const std::string& model)
{
    return {"model-" + model, "report --camera 0,20 --fov 34 --model " + model, model,
            "The report's scene by the model " + model};
}

Shot chart(const std::string& model)
{
    return {"grid-" + model, "grid --camera 25,10 --fov 30 --model " + model, model,
            "49 gold spheres, rougher to the right, more metallic upwards, by the model " + model};
}

Table error_table(const ReportContext& context)
{
    Table table{{"picture", "error", "reference's noise", "error without the noise", "FLIP"}, {}};
    for (const Entry& entry : context.entries)
        table.rows.push_back({entry.figure, percent(entry.proof.error), noise_text(entry.proof.noise),
                              percent(without_noise(entry.proof.error, entry.proof.noise)),
                              rounded(entry.proof.flip)});
    return table;
}

Gallery heat_maps(const ReportContext& context)
{
    Gallery gallery;
    for (const Entry& entry : context.entries) {
        PagePicture picture = entry.proof.heat;
        picture.title = entry.figure;
        picture.numbers = {{"error", percent(entry.proof.error)}, {"FLIP", rounded(entry.proof.flip)}};
        gallery.pictures.push_back(std::move(picture));
    }
    return gallery;
}

Comparison models(ReportContext& context, Shot (*shot)(const std::string&), const std::string& figure)
{
    Comparison comparison;
    std::vector<PagePicture> references;
    for (const char* model : {"phong", "ggx"}) {
        comparison.pictures.push_back(context.proven(shot(model), text(figure, ", ", model)));
        if (!context.references)
            continue;
        references.push_back(context.entries.back().proof.reference);
        references.back().title = text(model, ", path-traced");
    }
    comparison.pictures.insert(comparison.pictures.end(), references.begin(), references.end());
    return comparison;
}

Gallery tone_curves(ReportContext& context)
{
    Gallery gallery;
    for (const char* curve : tones) {
        gallery.pictures.push_back(context.renderer.picture(toned(curve)));
        const image::CodeImage codes = context.renderer.codes(toned(curve));
        const image::RadianceImage& light = context.renderer.frame(toned(curve)).radiance;
        gallery.pictures.back().numbers = {{"mean luminance", percent(compare::displayed_luminance(codes))},
                                           {"saturation", percent(compare::mean_saturation(codes, light))}};
    }
    return gallery;
}

// Error without the reference's noise, by number of samples.
Curve convergence(ShotRenderer& renderer, const std::string& name, const Shot& shot)
{
    Curve curve{name, {}, {}};
    const image::RadianceImage exact = cut_light(renderer.reference(shot).radiance);
    const std::optional<double> noise = cut_noise(renderer.reference(shot));
    for (const int samples : {1, 2, 5, 10, 20, 40, 80, 160, 320}) {
        Shot sampled = shot;
        sampled.words += text(" --samples ", samples);
        const image::RadianceImage drawn = cut_light(renderer.frame(sampled).radiance);
        const double error = compare::difference({drawn, exact}, light_cut).relative_rmse;
        curve.x.push_back(samples);
        curve.y.push_back(std::max(1e-3, without_noise(error, noise)));
    }
    return curve;
}

Plot convergence_plot(ReportContext& context)
{
    Plot plot{
        "samples",
        "error without the reference's noise",
        "Error falls with the number of samples for ggx and stays where the approximations put it for phong",
        {}};
    plot.curves = {
        convergence(context.renderer, "ggx, 49 spheres", chart("ggx")),
        convergence(context.renderer, "phong, \u03b1 = 625, matched levels", reflecting(625, "matched")),
        convergence(context.renderer, "phong, \u03b1 = 625, the report's levels", reflecting(625, "report"))};
    return plot;
}

void add_proofs(ReportContext& context, Section& section)
{
    section.figures.push_back(
        {"beyond-errors", "Every figure against its reference",
         "Relative RMSE of linear light, cut at 1 in both. What a reference's own noise adds is "
         "independent of the picture's error and can be taken off. FLIP is HDR-FLIP's mean.",
         error_table(context)});
    section.figures.push_back({"beyond-heat", "Where they err",
                               "Relative error of light cut at 1 at each pixel, from black over red to light "
                               "yellow at 100 % and more.",
                               heat_maps(context)});
    section.figures.push_back({"beyond-approximations", "What the report's approximations cost",
                               approximations_caption, approximations(context.renderer)});
    section.figures.push_back(
        {"beyond-convergence", "More samples",
         "The ggx pass converges to the integral; from 256 samples on pixels of curved surfaces "
         "are also seen in sixteen places, which is the step at the end. The report's pass "
         "converges to something else: its samples are never divided by their density.",
         convergence_plot(context)});
}

} // namespace

Section beyond(ReportContext& context)
{
    Section section{
        "beyond",
        "Beyond the report",
        {"A path tracer that shares the equations but none of the approximations draws every figure "
         "again, at as many bounces as image based lighting claims to stand for: direct light, without "
         "shadows."},
        {}};
    if (!context.references)
        section.text.push_back("This page was made with --quick, without references: errors are left out.");
    Comparison scenes = models(context, modelled, "The report's scene"),
               charts = models(context, chart, "49 spheres");
    if (context.references)
        add_proofs(context, section);
    section.figures.push_back(
        {"beyond-models", "ggx beside phong",
         "The same scene by the report's model and by glTF's, whose lobe keeps its energy and "
         "whose masking knows the surface's roughness.",
         scenes});
    section.figures.push_back(
        {"beyond-grid", "All roughnesses at once",
         "Perceptual roughness from 0 to 1 to the right, metalness from 0 to 1 upwards.", charts});
    section.figures.push_back(
        {"beyond-tones", "Tone curves", "One light through five curves.", tone_curves(context)});
    return section;
}

} // namespace lambent::report
