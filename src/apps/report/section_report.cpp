// The report's figures by its own pipeline, each beside the same light in our order of things.
#include "apps/report/desk.h"
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

std::string difference(Desk& desk, const Shot& report, const Shot& light)
{
    return percent(compare::code_difference(desk.workshop.codes(report), desk.workshop.codes(light)));
}

Matrix skies(Desk& desk)
{
    Matrix matrix{{row_of(Way::report), row_of(Way::light)}, {}, {}};
    for (const double exposure : sky_exposures)
        matrix.columns.push_back(text("e = ", exposure));
    for (const Way way : {Way::report, Way::light})
        for (const double exposure : sky_exposures) {
            const Shot shot = sky(way, exposure);
            matrix.pictures.push_back(desk.workshop.picture(shot));
            if (way == Way::report)
                matrix.pictures.back().numbers.push_back(
                    {"difference", difference(desk, shot, sky(Way::light, exposure))});
        }
    return matrix;
}

Table sky_table(Desk& desk)
{
    Table table{{"exposure", "mean code", "saturation", "blank", "near black", "mean code of light"}, {}};
    for (const double exposure : sky_exposures) {
        const compare::Look look = compare::look_of(desk.workshop.codes(sky(Way::report, exposure)));
        const compare::Look light = compare::look_of(desk.workshop.codes(sky(Way::light, exposure)));
        table.rows.push_back({text(exposure), percent(look.mean), percent(look.saturation),
                              percent(look.blank), percent(look.black), percent(light.mean)});
    }
    return table;
}

Matrix charts(Desk& desk)
{
    Matrix matrix{{row_of(Way::nonlinear), row_of(Way::report), row_of(Way::light)}, {}, {}};
    for (const double exposure : chart_exposures)
        matrix.columns.push_back(text("e = ", exposure));
    for (const Way way : {Way::nonlinear, Way::report, Way::light})
        for (const double exposure : chart_exposures) {
            const Shot shot = chart(way, exposure);
            matrix.pictures.push_back(desk.workshop.picture(shot));
            const double saturation =
                compare::mean_saturation(desk.workshop.codes(shot), desk.workshop.frame(shot).radiance);
            matrix.pictures.back().numbers.push_back({"saturation", percent(saturation)});
        }
    return matrix;
}

// What was found here, which under another light need not be what the report found.
std::string chart_caption(Workshop& workshop)
{
    std::string more, less;
    for (const double exposure : chart_exposures) {
        const Shot linear = chart(Way::report, exposure), nonlinear = chart(Way::nonlinear, exposure);
        const auto saturation = [&](const Shot& shot) {
            return compare::mean_saturation(workshop.codes(shot), workshop.frame(shot).radiance);
        };
        std::string& list = saturation(linear) > saturation(nonlinear) ? more : less;
        list += text(list.empty() ? "" : ", ", exposure);
    }
    return text("Five exposures. The report finds linear colour the more saturated one: here it is at ",
                more.empty() ? "none" : more, less.empty() ? "" : text(", and is not at ", less),
                ". Its ambient pass raises colours to 2.2 and never takes the root again.");
}

// Structure of a few pixels that the same pass with many samples does not have.
double blockiness(Workshop& workshop, const Shot& shot)
{
    Shot limit = shot;
    limit.words += " --samples 1024";
    return compare::fine_difference(workshop.frame(shot).radiance, workshop.frame(limit).radiance);
}

Matrix mirrors(Desk& desk, const std::string& shape)
{
    Matrix matrix{{row_of(Way::report), row_of(Way::light)}, {}, {}};
    for (const int exponent : reflecting_exponents)
        matrix.columns.push_back(text("\u03b1 = ", exponent));
    for (const Way way : {Way::report, Way::light})
        for (const int exponent : reflecting_exponents) {
            const Shot shot = mirror(way, shape, exponent);
            matrix.pictures.push_back(desk.workshop.picture(shot));
            if (shape == "plane" && exponent == 15625)
                matrix.pictures.back().numbers.push_back(
                    {"blockiness", percent(blockiness(desk.workshop, shot))});
            if (way == Way::report)
                matrix.pictures.back().numbers.push_back(
                    {"difference", difference(desk, shot, mirror(Way::light, shape, exponent))});
        }
    return transposed(matrix);
}

} // namespace

Section own_pipeline(Desk& desk)
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
    section.figures.push_back(
        {"own-sky", "The sky sphere at six exposures",
         "The report says of 7000 that it is a bright wash, of 70 that it exposes well, of 1 that it is "
         "twilight "
         "with nothing bright left but highlights. Beside it the same light, bent once, at the end. The "
         "difference is the RMS of that of the codes, of 255; on the sky the two differ by the power of 2.2 "
         "alone, of light that was linear already.",
         transposed(skies(desk))});
    section.figures.push_back(
        {"own-sky-numbers", "The captions, measured",
         "Means over all pixels. Blank: every channel at least 250. Near black: none above 25.",
         sky_table(desk)});
    section.figures.push_back({"own-diffuse", "Diffuse light, nonlinear and linear",
                               chart_caption(desk.workshop), transposed(charts(desk))});
    section.figures.push_back(
        {"own-sphere", "From paper to mirror, on a sphere",
         "A mirror reflects a quarter of the light that is straight before it and more than all of it at a "
         "slant, for samples are not divided by their density. The root of the mean makes up for some of it.",
         mirrors(desk, "sphere")});
    section.figures.push_back(
        {"own-plane", "The same on a plane",
         "Each sample is one texel of one level: on a plane, which spreads few of them over many pixels, "
         "they "
         "show as facets and ribs, and the sphere hides them. Blockiness at 15625 is the structure of a few "
         "pixels by which a picture differs from the same pass with 1024 samples, over the mean.",
         mirrors(desk, "plane")});
    return section;
}

} // namespace lambent::report
