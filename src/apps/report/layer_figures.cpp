#include "apps/report/layer_figures.h"

#include "apps/common/layer_files.h"
#include "apps/report/measurements.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lambent::report {
namespace {

constexpr const char* whole_picture = "sum";

const draw::Layer& layer_named(const draw::Frame& frame, const std::string& name)
{
    for (const draw::Layer& layer : frame.layers)
        if (layer.name == name)
            return layer;
    throw std::logic_error(text("no layer is named ", name));
}

PagePicture layer_shown(ReportContext& context, const draw::Layer& layer, const Shot& shot,
                        const std::string& picture_name)
{
    ShotRenderer& renderer = context.renderer;
    const std::string file = shot.name + ".png";
    image::CodeImage codes = cli::layer_picture(layer, parse_render(renderer.words_of(shot)).display);
    PagePicture picture{file, codes.width, codes.height, shot.title, shot.alt, {}, {}};
    Words command = renderer.words_of(shot);
    command.insert(command.begin(), {"lambent", "render"});
    command.insert(command.end(), {"--layers", "layers", "-o", picture_name + ".png"});
    picture.commands = {typed(command), typed({"cp", text("layers/", layer.name, ".png"), file})};
    renderer.write(std::move(codes), file);
    return picture;
}

} // namespace

double worst_difference(const draw::Frame& frame)
{
    double worst = 0.0;
    for (std::size_t i = 0; i < frame.radiance.values.size(); ++i) {
        if (i % 4 == 3)
            continue;
        double sum = 0.0;
        for (const draw::Layer& layer : frame.layers)
            if (layer.kind == draw::Layer::Kind::light)
                sum += static_cast<double>(layer.image.values[i]);
        const auto value = static_cast<double>(frame.radiance.values[i]);
        worst = std::max(worst, std::fabs(sum - value) / std::max(1.0, value));
    }
    return worst;
}

FigureBody layer_pictures(ReportContext& context, const FigureData& figure)
{
    const Shot whole = shot_of(context.content, figure, {{figure.rows.name, whole_picture}});
    const draw::Frame frame = context.renderer.layers(whole);
    Gallery gallery;
    for (const Values& values : axis_values(figure)) {
        const std::string& name = values.at(figure.rows.name);
        const Shot shot = shot_of(context.content, figure, values);
        gallery.pictures.push_back(name == whole_picture
                                       ? context.renderer.picture(shot)
                                       : layer_shown(context, layer_named(frame, name), shot, whole.name));
        add_measurements(context, {figure, values, shot}, gallery.pictures.back());
    }
    return gallery;
}

} // namespace lambent::report
