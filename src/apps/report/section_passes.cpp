#include "apps/common/layer_files.h"
#include "apps/report/report_context.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lambent::report {
namespace {

Shot scene()
{
    return {"passes-sum", "report --model phong --camera 0,20 --fov 34", "the picture",
            "A red sphere and a blue teapot on a plane, with all their light"};
}

struct Description {
    const char *title, *alt;
};

const std::map<std::string, Description> described = {
    {"diffuse", {"diffuse colour", "Flat red, blue and grey: the diffuse colours"}},
    {"specular", {"specular colour", "Flat greys: the specular colours"}},
    {"exponent", {"exponent", "Grey by the logarithm of the Phong exponent"}},
    {"normal", {"normal", "Directions of the surfaces as colours"}},
    {"depth", {"depth", "Near surfaces white, far ones dark"}},
    {"irradiance", {"irradiance", "Light that arrives from the environment around each normal"}},
    {"light_direct", {"direct lights", "Light of one directional and two point lights alone"}},
    {"light_ambient", {"ambient", "Diffuse light of the environment alone"}},
    {"light_specular", {"specular", "Reflected light of the environment alone"}},
    {"light_background", {"background", "The environment, black where surfaces stand"}},
};

bool is_light(const draw::Layer& layer)
{
    return layer.kind == draw::Layer::Kind::light;
}

// The largest difference between a value of the picture and the sum of its passes.
double worst_difference(const draw::Frame& frame)
{
    double worst = 0.0;
    for (std::size_t i = 0; i < frame.radiance.values.size(); ++i) {
        if (i % 4 == 3)
            continue;
        double sum = 0.0;
        for (const draw::Layer& layer : frame.layers)
            sum += is_light(layer) ? static_cast<double>(layer.image.values[i]) : 0.0;
        const auto value = static_cast<double>(frame.radiance.values[i]);
        worst = std::max(worst, std::fabs(sum - value) / std::max(1.0, value));
    }
    return worst;
}

PagePicture layer_of(ShotRenderer& renderer, const draw::Layer& layer)
{
    const Description& words = described.at(layer.name);
    const std::string file = text("passes-", layer.name, ".png");
    image::CodeImage codes = cli::layer_picture(layer, parse_render(renderer.words_of(scene())).display);
    PagePicture picture{file, codes.width, codes.height, words.title, words.alt, {}, {}};
    Words command = renderer.words_of(scene());
    command.insert(command.begin(), {"lambent", "render"});
    command.insert(command.end(), {"--layers", "layers", "-o", "passes-sum.png"});
    picture.commands = {typed(command), typed({"cp", text("layers/", layer.name, ".png"), file})};
    renderer.write(std::move(codes), file);
    return picture;
}

} // namespace

Section passes(ReportContext& context)
{
    const draw::Frame frame = context.renderer.layers(scene());
    Gallery buffer, light;
    for (const draw::Layer& layer : frame.layers)
        if (described.contains(layer.name))
            (is_light(layer) ? light : buffer).pictures.push_back(layer_of(context.renderer, layer));
    PagePicture sum = context.renderer.picture(scene());
    sum.numbers.push_back({"furthest from the sum of its passes", rounded(worst_difference(frame))});
    light.pictures.push_back(std::move(sum));
    Section section{
        "passes",
        "The G-buffer and its passes",
        {"A deferred renderer first writes down what is seen at each pixel, then adds light to it in "
         "passes. Each layer can be had as an image with --layers."},
        {}};
    section.figures.push_back({"passes-buffer", "The G-buffer", "What is written down.", buffer});
    section.figures.push_back(
        {"passes-light", "The passes, and what they add up to",
         "Direct lights, ambient, specular, background, and the picture. The number is the "
         "largest difference between a value and the sum of its passes, relative above 1.",
         light});
    return section;
}

} // namespace lambent::report
