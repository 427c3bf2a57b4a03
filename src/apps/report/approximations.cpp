#include "apps/report/approximations.h"

#include "apps/report/report_context.h"
#include "base/text.h"
#include "compare/brightness_fit.h"

#include <cmath>

namespace lambent::report {
namespace {

// The whole-sphere mean of what a white specular surface reflects of a white environment, exactly: 1 if none is lost.
double kept_energy(ShotRenderer& renderer, int exponent)
{
    const Shot shot{"",
                    text("sphere --model phong --kd 0,0,0 --ks 1,1,1 --alpha ", exponent,
                         " --env furnace --background none --camera 0,0 --size 64x64"),
                    "", ""};
    return mean_on_surfaces(renderer.reference(shot).radiance);
}

} // namespace

const char* const approximations_caption =
    "RMSE over mean of light cut at 1, on the surfaces alone, of the reflecting sphere and plane. Mip level: "
    "forty samples at "
    "the "
    "report's levels against the same pass with 1024 finely read ones; matched levels likewise. Lobe: that "
    "limit, "
    "samples around R that are not divided by their density, against the exact integral; then the same after "
    "the one "
    "factor on the whole picture that suits it best: what is left is the lobe's shape. Masking: the share of "
    "light "
    "that the exact BRDF itself gives back in a white furnace, 100 % if 1/(L\u00b7H)\u00b2 lost none.";

Table approximations(ShotRenderer& renderer)
{
    Table table{{"\u03b1", "mip level", "matched levels", "lobe around R", "best factor", "lobe's shape",
                 "masking keeps"},
                {}};
    for (const int exponent : reflecting_exponents) {
        const Shot matched = reflecting(exponent, "matched");
        Shot limit = matched;
        limit.words += " --samples 1024";
        const std::optional<double> noise = cut_noise(renderer.reference(matched));
        const image::RadianceImage exact = cut_light(renderer.reference(matched).radiance),
                                   converged = cut_light(renderer.frame(limit).radiance);
        const auto error = [&](const Shot& shot) {
            return compare::brightness_fit({cut_light(renderer.frame(shot).radiance), converged}).error;
        };
        const compare::BrightnessFit lobe = compare::brightness_fit({converged, exact});
        table.rows.push_back({text(exponent), percent(error(reflecting(exponent, "report"))),
                              percent(error(matched)), percent(without_noise(lobe.error, noise)),
                              rounded(lobe.factor), percent(without_noise(lobe.left, noise)),
                              percent(kept_energy(renderer, exponent))});
    }
    return table;
}

} // namespace lambent::report
