#include "apps/viewer/present_frame.h"

#include "apps/common/layer_files.h"
#include "apps/common/picture_audit.h"
#include "apps/common/picture_file.h"
#include "apps/viewer/session.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace lambent::viewer {
namespace {

bool is_transparent(const Plan& plan)
{
    return plan.arguments.settings.background.kind == draw::Background::Kind::none;
}

// The layers are named after the model ggx; phong has others in place of two of them.
std::string layer_name(const Plan& plan)
{
    if (plan.arguments.settings.model != draw::Model::phong)
        return plan.layer;
    if (plan.layer == "base_color")
        return "diffuse";
    return plan.layer == "alpha" ? "exponent" : plan.layer;
}

// Null where the picture itself is asked for, or a layer that the model does not have.
const draw::Layer* layer_of(const Plan& plan, const draw::Frame& frame)
{
    const auto found = std::find_if(frame.layers.begin(), frame.layers.end(),
                                    [&](const draw::Layer& layer) { return layer.name == layer_name(plan); });
    return plan.layer == "picture" || found == frame.layers.end() ? nullptr : &*found;
}

image::CodeImage codes_of(const Plan& plan, const draw::Frame& frame)
{
    if (const draw::Layer* const layer = layer_of(plan, frame))
        return cli::layer_picture(*layer, plan.arguments.display);
    return cli::picture_codes(frame.radiance, plan.arguments.display, is_transparent(plan));
}

ShownPicture picture_of(const Plan& plan, const draw::Frame& frame, double draw_ms)
{
    ShownPicture picture;
    picture.kind = plan.task == Plan::Task::moving  ? ShownPicture::Kind::moving
                   : plan.task == Plan::Task::still ? ShownPicture::Kind::still
                                                    : ShownPicture::Kind::rest;
    picture.codes = codes_of(plan, frame);
    const bool at_rest = plan.task == Plan::Task::rest || plan.task == Plan::Task::refine;
    picture.is_last = at_rest && !plan.is_compared && !plan.is_refined;
    picture.lacks_shadows = plan.lacks_shadows;
    picture.error = plan.error;
    complete_picture(plan, draw_ms, picture);
    return picture;
}

// Reports the surface point at the plan's place; nothing where that shows the background.
void pick(const Plan& plan, const draw::Frame& frame, Session& session)
{
    const auto depth = std::find_if(frame.layers.begin(), frame.layers.end(),
                                    [](const draw::Layer& layer) { return layer.name == "depth"; });
    if (depth == frame.layers.end())
        return;
    const image::RadianceImage& image = depth->image;
    const auto at = [](double part, int side) {
        return std::clamp(static_cast<int>(part * side), 0, side - 1);
    };
    const int x = at(plan.place[0], image.width), y = at(plan.place[1], image.height);
    const float* pixel = image.pixel(x, y);
    if (!(pixel[3] > 0.0f))
        return;
    const draw::RayMap rays = draw::ray_map(plan.arguments.settings.camera, image.width, image.height);
    const glm::vec3 direction =
        glm::normalize(rays.direction + (static_cast<float>(x) + 0.5f) * rays.direction_dx +
                       (static_cast<float>(y) + 0.5f) * rays.direction_dy);
    session.point_picked(glm::dvec3(rays.origin + pixel[0] / pixel[3] * direction), plan);
}

} // namespace

void complete_picture(const Plan& plan, double draw_ms, ShownPicture& picture)
{
    picture.width = plan.width;
    picture.height = plan.height;
    picture.scale = plan.scale;
    picture.draw_ms = draw_ms;
    picture.input = plan.input;
    picture.moment = plan.moment;
}

bool lacks_layer(const Plan& plan, const draw::Frame& frame)
{
    return plan.layer != "picture" && !layer_of(plan, frame);
}

void present_frame(const Plan& plan, const draw::Frame& frame, double draw_ms, Session& session)
{
    if (plan.task == Plan::Task::pick) {
        pick(plan, frame, session);
    } else if (plan.task == Plan::Task::save) {
        const display::Settings& display = plan.arguments.display;
        session.presenter().save(
            {plan.file,
             cli::picture_bytes(frame.radiance, display, is_transparent(plan), plan.file,
                                plan.error ? cli::notes_of(*plan.error) : image::Notes()),
             plan.command});
    } else {
        session.presenter().show(picture_of(plan, frame, draw_ms));
    }
}

} // namespace lambent::viewer
