// The report's figures by its own pipeline, each beside the same light in our order of things.
#include "apps/report/report_context.h"
#include "base/text.h"
#include "compare/appearance.h"

#include <cmath>

namespace lambent::report {
namespace {

// Texels of our room are brighter than those of the report's. So much of theirs makes the captions come true (the first
// table): as a factor on the exposure, for a power of a product is the product of powers.
constexpr double texel_scale = 0.3;

constexpr double sky_exposures[] = {7000, 700, 70, 7, 1, 0.1};
constexpr double chart_exposures[] = {700, 70, 7, 1, 0.1};

enum class Way { report, nonlinear, light };

std::string words_of(Way way, double exposure)
{
    const double scale = std::pow(texel_scale, way == Way::report ? 2.2 : 1.0);
    const std::string pipeline = way == Way::light       ? ""
                                 : way == Way::nonlinear ? " --pipeline report --space nonlinear"
                                                         : " --pipeline report";
    return text(" --model phong", pipeline, " --exposure ", rounded(scale * exposure, 4));
}

std::string name_of(Way way)
{
    return way == Way::light ? "light" : way == Way::nonlinear ? "nonlinear" : "report";
}

std::string row_of(Way way)
{
    return way == Way::light       ? "light, then the curve"
           : way == Way::nonlinear ? "the report's, nonlinear"
                                   : "the report's pipeline";
}

Shot sky(Way way, double exposure)
{
    const std::string e = text(exposure);
    return {text("own-sky-", name_of(way), "-", e),
            text("sphere --camera 200,4,5 --fov 60", words_of(way, exposure)), text("e = ", e),
            text("The room behind a small red sphere at exposure ", e, ", ", row_of(way))};
}

Shot chart(Way way, double exposure)
{
    const std::string e = text(exposure);
    return {text("own-diffuse-", name_of(way), "-", e),
            text("painted --ks 0,0,0 --alpha 1 --camera 240,14,2.6 --fov 34", words_of(way, exposure)),
            text("e = ", e),
            text("A sphere with a chart of colours on a tiled plane at exposure ", e, ", ", row_of(way))};
}

Shot mirror(Way way, const std::string& shape, int exponent)
{
    const std::string view =
        shape == "plane" ? "plane --camera 300,14,1.9 --fov 24" : "sphere --camera 240,14,2.6 --fov 34";
    return {text("own-", shape, "-", name_of(way), "-", exponent),
            text(view, " --kd 0.02,0.02,0.02 --ks 0.9,0.9,0.9 --alpha ", exponent, words_of(way, 7)),
            text("\u03b1 = ", exponent),
            text("A ", shape, " that reflects the room with exponent ", exponent, ", ", row_of(way))};
}

// A figure of direct light, by the BRDF and nothing else: its sums are what is shown.
Shot direct(Way way, Shot shot)
{
    shot.name = text("own-", shot.name, "-", name_of(way));
    shot.alt += ", " + row_of(way);
    if (way == Way::report)
        shot.words += " --pipeline report";
    return shot;
}

std::string difference(ReportContext& context, const Shot& report, const Shot& light)
{
    return percent(compare::code_difference(context.renderer.codes(report), context.renderer.codes(light)));
}

Matrix skies(ReportContext& context)
{
    Matrix matrix{{row_of(Way::report), row_of(Way::light)}, {}, {}};
    for (const double exposure : sky_exposures)
        matrix.columns.push_back(text("e = ", exposure));
    for (const Way way : {Way::report, Way::light})
        for (const double exposure : sky_exposures) {
            const Shot shot = sky(way, exposure);
            matrix.pictures.push_back(context.renderer.picture(shot));
            if (way == Way::report)
                matrix.pictures.back().numbers.push_back(
                    {"difference", difference(context, shot, sky(Way::light, exposure))});
        }
    return matrix;
}

Table sky_table(ReportContext& context)
{
    Table table{{"exposure", "mean code", "saturation", "blank", "near black", "mean code of light"}, {}};
    for (const double exposure : sky_exposures) {
        const compare::Look look = compare::look_of(context.renderer.codes(sky(Way::report, exposure)));
        const compare::Look light = compare::look_of(context.renderer.codes(sky(Way::light, exposure)));
        table.rows.push_back({text(exposure), percent(look.mean), percent(look.saturation),
                              percent(look.blank), percent(look.black), percent(light.mean)});
    }
    return table;
}

// What the captions ask of the room's brightness: a wash at 7000, three of four pixels of which are blank; a good exposure
// at 70; nothing blank in the twilight of 1.
Table scale_table(ReportContext& context)
{
    Table table{{"texels times", "blank at 7000", "neither blank nor near black at 70", "blank at 1"}, {}};
    for (const double scale : {0.1, 0.2, texel_scale, 0.4, 0.6}) {
        const auto look = [&](double exposure) {
            Shot shot = sky(Way::report, exposure);
            shot.words += text(" --exposure ", rounded(std::pow(scale, 2.2) * exposure, 4));
            return compare::look_of(context.renderer.codes(shot));
        };
        const compare::Look well = look(70);
        table.rows.push_back({text(scale), percent(look(7000).blank), percent(1.0 - well.blank - well.black),
                              percent(look(1).blank)});
    }
    return table;
}

Matrix charts(ReportContext& context)
{
    Matrix matrix{{row_of(Way::nonlinear), row_of(Way::report), row_of(Way::light)}, {}, {}};
    for (const double exposure : chart_exposures)
        matrix.columns.push_back(text("e = ", exposure));
    for (const Way way : {Way::nonlinear, Way::report, Way::light})
        for (const double exposure : chart_exposures) {
            const Shot shot = chart(way, exposure);
            matrix.pictures.push_back(context.renderer.picture(shot));
            const double saturation =
                compare::mean_saturation(context.renderer.codes(shot), context.renderer.frame(shot).radiance);
            matrix.pictures.back().numbers.push_back({"saturation", percent(saturation)});
        }
    return matrix;
}

// What was found here, which under another light need not be what the report found.
std::string chart_caption(ShotRenderer& renderer)
{
    std::string more, less;
    for (const double exposure : chart_exposures) {
        const Shot linear = chart(Way::report, exposure), nonlinear = chart(Way::nonlinear, exposure);
        const auto saturation = [&](const Shot& shot) {
            return compare::mean_saturation(renderer.codes(shot), renderer.frame(shot).radiance);
        };
        std::string& list = saturation(linear) > saturation(nonlinear) ? more : less;
        list += text(list.empty() ? "" : ", ", exposure);
    }
    return text("Five exposures. The report finds linear colour the more saturated one: here it is at ",
                more.empty() ? "none" : more, less.empty() ? "" : text(", and is not at ", less),
                ". Its ambient pass raises colours to 2.2 and never takes the root again.");
}

// Structure of a few pixels that the same pass with many samples does not have.
double blockiness(ShotRenderer& renderer, const Shot& shot)
{
    Shot limit = shot;
    limit.words += " --samples 1024";
    return compare::fine_difference(renderer.frame(shot).radiance, renderer.frame(limit).radiance);
}

Matrix mirrors(ReportContext& context, const std::string& shape)
{
    Matrix matrix{{row_of(Way::report), row_of(Way::light)}, {}, {}};
    for (const int exponent : reflecting_exponents)
        matrix.columns.push_back(text("\u03b1 = ", exponent));
    for (const Way way : {Way::report, Way::light})
        for (const int exponent : reflecting_exponents) {
            const Shot shot = mirror(way, shape, exponent);
            matrix.pictures.push_back(context.renderer.picture(shot));
            if (shape == "plane" && exponent == 15625)
                matrix.pictures.back().numbers.push_back(
                    {"blockiness", percent(blockiness(context.renderer, shot))});
            if (way == Way::report)
                matrix.pictures.back().numbers.push_back(
                    {"difference", difference(context, shot, mirror(Way::light, shape, exponent))});
        }
    return transposed(matrix);
}

Matrix direct_lights(ReportContext& context)
{
    Matrix matrix{{row_of(Way::report), row_of(Way::light)}, {}, {}};
    for (const Shot& shot : direct_shots())
        matrix.columns.push_back(shot.title);
    for (const Way way : {Way::report, Way::light})
        for (const Shot& shot : direct_shots()) {
            matrix.pictures.push_back(context.renderer.picture(direct(way, shot)));
            if (way == Way::report)
                matrix.pictures.back().numbers.push_back(
                    {"difference", difference(context, direct(way, shot), direct(Way::light, shot))});
        }
    return transposed(matrix);
}

// The chart in nonlinear colour, as the report's column of that, but for the curve, which comes last.
Shot chart_with_curve_last(double exposure)
{
    Shot shot = chart(Way::light, exposure);
    shot.words += " --space nonlinear --ambient-brightness 2";
    return shot;
}

Table order_costs(ReportContext& context)
{
    Table table{{"exposure", "the power of 2.2", "the curve before the BRDF"}, {}};
    for (const double exposure : chart_exposures)
        table.rows.push_back(
            {text(exposure), difference(context, sky(Way::report, exposure), sky(Way::light, exposure)),
             difference(context, chart(Way::nonlinear, exposure), chart_with_curve_last(exposure))});
    return table;
}

// Of white light, by the mean over the disc of a white sphere.
Table density_costs(ReportContext& context)
{
    Table table{{"\u03b1", "the mean of samples sends on", "its BRDF does", "of it, the mean"}, {}};
    for (const int exponent : reflecting_exponents) {
        const Shot white = {"",
                            text("sphere --model phong --kd 0,0,0 --ks 1,1,1 --alpha ", exponent,
                                 " --env furnace --background none --camera 0,0 --size 96x96"),
                            "", ""};
        const double mean = mean_on_surfaces(context.renderer.frame(white).radiance),
                     exact = mean_on_surfaces(context.renderer.reference(white).radiance);
        table.rows.push_back({text(exponent), percent(mean), percent(exact), percent(mean / exact)});
    }
    return table;
}

} // namespace

Section own_pipeline(ReportContext& context)
{
    Section section{
        "own",
        "The report's own pipeline",
        {"The report bends every value that it reads of its environment by the tone curve first, raised to "
         "2.2 "
         "although it was linear light, and lights its surfaces with what comes out; we add up light and "
         "bend "
         "the sum. Its captions fit its own order of things and not ours, so here it is, to the letter.",
         text("Texels of this room are taken ", texel_scale,
              " times as bright, as a factor on the exposure: so bright the captions below come true.")},
        {}};
    section.figures = {
        {"own-direct", "Lights without size",
         "The report's own figures of its BRDF: a sphere at \u03b1 = 0.1, a crescent against the light and "
         "even from the light's side, then with a point light; a teapot that is nearly a mirror; an oval "
         "under a low light. Its direct light has no curve: sums are shown as they are, cut at 1. The "
         "difference is the RMS of that of the codes, of 255.",
         direct_lights(context)},
        {"own-diffuse", "Diffuse light, nonlinear and linear", chart_caption(context.renderer),
         transposed(charts(context))},
        {"own-sky", "The sky sphere at six exposures",
         "The report says of 7000 that it is a bright wash, of 70 that it exposes well, of 1 that it is "
         "twilight with nothing bright left but highlights. Beside it the same light, bent once, at the end. "
         "On the sky the two differ by the power of 2.2 alone, of light that was linear already.",
         transposed(skies(context))},
        {"own-sky-numbers", "The captions, measured",
         "Means over all pixels. Blank: every channel at least 250. Near black: none above 25.",
         sky_table(context)},
        {"own-scale", "How bright the room is taken",
         text(
             "Of 7000 the report says that it is a wash: let three of four pixels be blank. Of 1, that it is "
             "twilight: let none be. Texels ",
             texel_scale, " times as bright do both, and leave most of 70 between the ends."),
         scale_table(context)},
        {"own-sphere", "From paper to mirror, on a sphere",
         "The report goes from one flat colour at 1 to a mirror at 390625, and finds its blocks hidden on a "
         "sphere. A mirror reflects a quarter of the light that is straight before it and more than all of "
         "it at a slant, for samples are not divided by their density. The root of the mean makes up for "
         "some of it.",
         mirrors(context, "sphere")},
        {"own-plane", "The same on a plane",
         "The report finds blocks at 15625 here. Each sample is one texel of one level: on a plane, which "
         "spreads few of them over many pixels, they show as facets and ribs. Blockiness at 15625 is the "
         "structure of a few pixels by which a picture differs from the same pass with 1024 samples, over "
         "the mean.",
         mirrors(context, "plane")},
        {"own-order", "What its order of things costs",
         "RMS of the difference of codes, of 255. The power of 2.2, on light that was linear already: on the "
         "sky, with it and without. The curve before the BRDF: on the chart of colours, in nonlinear colour "
         "throughout, once on each value that lights it and once on what is seen.",
         order_costs(context)},
        {"own-density", "What the missing density costs",
         "A white sphere in white light. The report's sum has neither D(H) nor the density of its samples, "
         "as "
         "if the one made up for the other. The mean over the disc that the sum sends on, before its root, "
         "and what the integral of the BRDF does.",
         density_costs(context)}};
    return section;
}

} // namespace lambent::report
