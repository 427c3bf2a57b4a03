#include "apps/report/report_context.h"
#include "apps/report/oval.h"
#include "compare/appearance.h"

namespace lambent::report {
namespace {

const std::string matt = "sphere --model phong --alpha 0.1 --kd 0.1,0.1,0.1 --ks 0.9,0.9,0.9 "
                         "--light directional:150,10,3,3,3 --fov 34 --aa 16";

Shot glancing()
{
    return {"direct-glancing", matt + " --camera 0,10,2.4", "against the light",
            "A sphere with a thin bright crescent: the light comes from behind", false};
}

Shot lit_side()
{
    return {"direct-lit-side", matt + " --camera 140,15,2.4", "from the light's side",
            "The same sphere, evenly bright from edge to edge", false};
}

Shot with_point()
{
    return {"direct-point", matt + " --light point:0.25,0.95,0.75,0.5,0.2,0.06 --camera 0,10,2.4",
            "with a point light", "The crescent, and an orange point light near the front of the sphere",
            false};
}

Shot teapot()
{
    return {"direct-teapot",
            "teapot --model phong --alpha 20000 --kd 0.03,0.05,0.12 --ks 0.5,0.5,0.5 "
            "--light directional:30,40,2.5,2.5,2.5 --light directional:-60,25,0.6,0.5,0.4 --camera 20,15 "
            "--fov 26",
            "\u03b1 = 20000", "A blue teapot with a highlight as small as a pinhead", false};
}

Shot streak()
{
    return {"direct-oval",
            "plane --model phong --alpha 20 --kd 0.1,0.1,0.1 --ks 0.3,0.3,0.3 "
            "--light point:0,0.15,-0.3,0.12,0.1,0.07 --camera 0,14,2.2 --fov 34 --aa 16",
            "\u03b1 = 20", "A plane with a highlight drawn out towards the viewer", false};
}

void add_luminance(ShotRenderer& renderer, const Shot& shot, PagePicture& picture)
{
    picture.numbers.push_back(
        {"mean luminance", percent(compare::displayed_luminance(renderer.codes(shot)))});
}

} // namespace

std::vector<Shot> direct_shots()
{
    return {glancing(), lit_side(), with_point(), teapot(), streak()};
}

Section direct_light(ReportContext& context)
{
    Section section{
        "direct",
        "Physically based lighting",
        {"The report's BRDF: a Phong distribution of microfacets with exponent \u03b1, Schlick's Fresnel "
         "term and the masking 1/(L\u00b7H)\u00b2, under directional and point lights. Below \u03b1 = 1 the "
         "lobe is wider than a hemisphere's cosine and a highlight fills all that is lit."},
        {}};
    Gallery spheres;
    for (const Shot& shot : {glancing(), lit_side(), with_point()}) {
        spheres.pictures.push_back(context.proven(shot, "Sphere " + shot.title));
        add_luminance(context.renderer, shot, spheres.pictures.back());
    }
    section.figures.push_back(
        {"direct-sphere", "A sphere at \u03b1 = 0.1",
         "One directional light, seen at a glancing angle and from its own side; then with a "
         "local point light.",
         spheres});
    Gallery sharp;
    sharp.pictures.push_back(context.proven(teapot(), "Teapot"));
    add_luminance(context.renderer, teapot(), sharp.pictures.back());
    sharp.pictures.push_back(context.proven(streak(), "Plane under a low light"));
    const Oval oval =
        highlight_shape(context.renderer.frame(streak()).radiance, context.renderer.camera(streak()));
    sharp.pictures.back().numbers.push_back(
        {"highlight, length to width on the plane", rounded(oval.on_ground) + " : 1"});
    sharp.pictures.back().numbers.push_back({"in the picture", rounded(oval.in_picture) + " : 1"});
    section.figures.push_back(
        {"direct-highlights", "Highlights",
         "A teapot at \u03b1 = 20000, nearly a mirror. A point light low over a plane at "
         "\u03b1 = 20: where the half vector turns slowly the highlight stretches into an oval, "
         "measured at half its peak.",
         sharp});
    return section;
}

} // namespace lambent::report
