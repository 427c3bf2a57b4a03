#include "apps/report/report_context.h"
#include "base/text.h"
#include "compare/appearance.h"

namespace lambent::report {
namespace {

Shot ground(const std::string& name, const std::string& how, const std::string& title)
{
    return {
        "blocks-" + name,
        "plane --model phong --kd 0.02,0.02,0.02 --ks 0.9,0.9,0.9 --alpha 15625 --camera 300,14,1.9 --fov "
        "24 " +
            how,
        title, "A plane that reflects a window, closely: " + title};
}

const std::string limit_samples = "--samples 1024";

// Of the sphere alone: how far it is from one flat colour.
double spread(ShotRenderer& renderer, const Shot& shot)
{
    Shot alone = shot;
    alone.words.replace(0, alone.words.find(' '), "sphere");
    return compare::luminance_spread(renderer.frame(alone).radiance);
}

Matrix exponents(ReportContext& context)
{
    Matrix matrix{{"the report's levels", "matched levels"}, {}, {}};
    for (const int exponent : reflecting_exponents)
        matrix.columns.push_back(text("\u03b1 = ", exponent));
    std::vector<PagePicture> references;
    for (const char* levels : {"report", "matched"})
        for (const int exponent : reflecting_exponents) {
            const Shot shot = reflecting(exponent, levels);
            const bool matched = levels == std::string("matched");
            matrix.pictures.push_back(context.proven(
                shot, text("Reflecting sphere, \u03b1 = ", exponent, ", ", levels, " levels")));
            matrix.pictures.back().numbers.push_back(
                {"spread on the sphere", percent(spread(context.renderer, shot))});
            if (matched && context.references)
                references.push_back(context.entries.back().proof.reference);
        }
    if (context.references) {
        matrix.rows.push_back("path-traced");
        matrix.pictures.insert(matrix.pictures.end(), references.begin(), references.end());
    }
    return transposed(matrix);
}

Comparison blocks(ReportContext& context)
{
    const Shot report = ground("report", "--mip-level report", "the report's levels"),
               matched = ground("matched", "--mip-level matched", "matched levels"),
               limit = ground("limit", limit_samples, "1024 samples");
    const image::RadianceImage& exact = context.renderer.frame(limit).radiance;
    Comparison comparison;
    for (const Shot& shot : {report, matched}) {
        PagePicture picture = context.proven(shot, "Ground at \u03b1 = 15625, " + shot.title);
        picture.numbers.push_back(
            {"blockiness", percent(compare::fine_difference(context.renderer.frame(shot).radiance, exact))});
        comparison.pictures.push_back(std::move(picture));
    }
    comparison.pictures.push_back(context.renderer.picture(limit));
    if (context.references)
        comparison.pictures.push_back(context.entries.back().proof.reference);
    return comparison;
}

} // namespace

Section specular_light(ReportContext& context)
{
    Section section{
        "specular",
        "Specular image based lighting",
        {"Forty directions around the mirrored view, each read from a blurred copy of the environment "
         "that is as wide as its share of the lobe. The report takes the blur from a mip chain by a "
         "formula; lambent from Gaussian blurs matched to the lobe, at points in a spiral."},
        {}};
    section.figures.push_back(
        {"specular-exponents", "From paper to mirror",
         "A sphere on a plane. At \u03b1 = 1 it is nearly one flat colour, most of all at the "
         "report's levels: the spread of luminance, standard deviation over mean, says how flat.",
         exponents(context)});
    section.figures.push_back(
        {"specular-blocks", "Blocks at \u03b1 = 15625",
         "A level of a mip chain shows its texels, for all forty samples of a narrow lobe read "
         "the same few. Blockiness is the structure of a few pixels by which a picture differs "
         "from the same pass with 1024 samples, over the mean.",
         blocks(context)});
    return section;
}

} // namespace lambent::report
