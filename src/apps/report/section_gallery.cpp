#include "apps/report/report_context.h"

namespace lambent::report {
namespace {

// Those of the documentation: larger than the figures, and JPEG.
const char* const size = " --size 960x540";

Shot porcelain()
{
    return {"teapot.jpg", std::string("teapot --env sky --camera 20,12 --fov 30") + size,
            "Porcelain, clear sky", "A white teapot under a clear sky"};
}

Shot report()
{
    return {"report.jpg", std::string("report") + size, "The report's scene",
            "A red sphere and a blue teapot on a grey plane, with three lights"};
}

Shot phong()
{
    return {"phong.jpg",
            std::string("teapot --model phong --alpha 20000 --kd 0.02,0.04,0.1 --ks 0.6,0.6,0.6 --env sky "
                        "--camera 20,12 --fov 30") +
                size,
            "The report's model, exponent 20000", "A dark blue teapot that mirrors the sky"};
}

Shot kitchen()
{
    return {"kitchen.jpg", std::string("sphere --camera 180,5") + size, "Red paint",
            "A glossy red sphere before the windows of the environment"};
}

} // namespace

Section gallery(ReportContext& context)
{
    Section section{
        "gallery",
        "Gallery",
        {"Models under the light of real places, drawn on the processor in a fraction of a second each: "
         "the light of an environment on every surface, diffuse and specular, as the pages below take "
         "it apart."},
        {}};
    Gallery pictures;
    for (const Shot& shot : {report(), porcelain(), kitchen(), phong()})
        pictures.pictures.push_back(context.renderer.picture(shot));
    section.figures.push_back({"gallery-pictures", "Four pictures",
                               "Each with the command that draws it, as all figures of this page.",
                               pictures});
    return section;
}

} // namespace lambent::report
