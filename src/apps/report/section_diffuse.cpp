#include "apps/report/report_context.h"
#include "base/text.h"
#include "compare/appearance.h"

namespace lambent::report {
namespace {

const char* const diffuse_exposures[] = {"700", "70", "7", "1", "0.1"};
const char* const background_exposures[] = {"7000", "700", "70", "7", "1", "0.1"};

Shot painted(const std::string& exposure, const std::string& space)
{
    return {"diffuse-" + space + "-" + exposure,
            "painted --model phong --ks 0,0,0 --camera 240,14,2.6 --fov 34 --exposure " + exposure +
                " --space " + space,
            "e = " + exposure,
            "A sphere with a chart of colours on a tiled plane, " + space + " colour, exposure " + exposure};
}

Shot room(const std::string& exposure)
{
    return {"background-" + exposure, "sphere --model phong --camera 200,4,5 --fov 60 --exposure " + exposure,
            "e = " + exposure, "The environment behind a small red sphere, at exposure " + exposure};
}

void add_tone_numbers(ShotRenderer& renderer, const Shot& shot, PagePicture& picture)
{
    const image::CodeImage codes = renderer.codes(shot);
    const image::RadianceImage& light = renderer.frame(shot).radiance;
    picture.numbers.push_back({"mean luminance", percent(compare::displayed_luminance(codes))});
    if (const double kept = compare::kept_hue_order(codes, light); kept < 1.0)
        picture.numbers.push_back({"hue order kept", percent(kept)});
}

double saturation(ShotRenderer& renderer, const Shot& shot)
{
    return compare::mean_saturation(renderer.codes(shot), renderer.frame(shot).radiance);
}

Matrix exposure_table(ReportContext& context)
{
    Matrix matrix{{"linear", "nonlinear"}, {}, {}};
    for (const char* exposure : diffuse_exposures)
        matrix.columns.push_back(text("e = ", exposure));
    for (const std::string& space : matrix.rows)
        for (const char* exposure : diffuse_exposures) {
            const Shot shot = painted(exposure, space);
            // The light is the same at every exposure: it is proven once.
            matrix.pictures.push_back(space == "linear" && exposure == std::string("1")
                                          ? context.proven(shot, "Diffuse light, linear colour")
                                          : context.renderer.picture(shot));
            add_tone_numbers(context.renderer, shot, matrix.pictures.back());
            matrix.pictures.back().numbers.push_back(
                {"saturation", percent(saturation(context.renderer, shot))});
        }
    return transposed(matrix);
}

Table saturation_table(ReportContext& context)
{
    Table table{{"exposure", "linear", "nonlinear", "ratio"}, {}};
    for (const char* exposure : diffuse_exposures) {
        const double linear = saturation(context.renderer, painted(exposure, "linear")),
                     nonlinear = saturation(context.renderer, painted(exposure, "nonlinear"));
        table.rows.push_back({exposure, percent(linear), percent(nonlinear), rounded(linear / nonlinear)});
    }
    return table;
}

// What was found here, which under another light need not be what the report found.
std::string saturation_caption(ShotRenderer& renderer)
{
    const auto more = [&](const char* exposure) {
        return saturation(renderer, painted(exposure, "linear")) >
               saturation(renderer, painted(exposure, "nonlinear"));
    };
    const std::string what = "Mean of (max - min) / max over the surfaces, as displayed. ";
    return what +
           (more("7") && more("70")
                ? "At 7 and at 70 linear colour is the more saturated one, as the report found by eye."
                : "The report found linear colour the more saturated one at 7 and at 70; under this light "
                  "it is not at both.");
}

// Whether each exposure, the highest first, shows more light than the next.
bool luminance_falls(ShotRenderer& renderer)
{
    double before = 2.0;
    for (const char* exposure : background_exposures) {
        const double luminance = compare::displayed_luminance(renderer.codes(room(exposure)));
        if (luminance >= before)
            return false;
        before = luminance;
    }
    return true;
}

} // namespace

Section diffuse_light(ReportContext& context)
{
    Section section{
        "diffuse",
        "Diffuse image based lighting and tone mapping",
        {"Every surface takes the irradiance around its normal from the environment. The curve "
         "(eC / (eC + 1)) to the power K/2.2 maps light to the display. Linear colour converts texels to "
         "light before the sum and light to codes after it; nonlinear colour does neither."},
        {}};
    section.figures.push_back(
        {"diffuse-exposures", "Exposure by colour space",
         "The same light at five exposures. The luminance is what a display shows. In the brightest tenth no "
         "channel overtakes another, unless a picture says so. Nonlinear colour pales first: its "
         "codes are sums of numbers that are not light.",
         exposure_table(context)});
    section.figures.push_back({"diffuse-saturation", "Saturation measured",
                               saturation_caption(context.renderer), saturation_table(context)});
    return section;
}

Section background(ReportContext& context)
{
    Section section{
        "background",
        "Background tone mapping",
        {"Where no surface stands the environment itself is seen, through the same exposure and the same "
         "curve as everything else: a window that blinds does so in the reflection too."},
        {}};
    Gallery pictures;
    for (const char* exposure : background_exposures) {
        const Shot shot = room(exposure);
        pictures.pictures.push_back(exposure == std::string("1") ? context.proven(shot, "Background")
                                                                 : context.renderer.picture(shot));
        add_tone_numbers(context.renderer, shot, pictures.pictures.back());
    }
    section.figures.push_back(
        {"background-exposures", "Six exposures",
         luminance_falls(context.renderer)
             ? "From 7000 down to 0.1: the mean luminance that is displayed falls with each step. No channel "
               "of the highlights overtakes another, unless a picture says so."
             : "From 7000 down to 0.1. Under this light some steps show the same mean luminance.",
         pictures});
    return section;
}

} // namespace lambent::report
