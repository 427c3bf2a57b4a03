#include "apps/report/measurements.h"

#include "apps/report/layer_figures.h"
#include "apps/report/oval.h"
#include "base/text.h"
#include "compare/appearance.h"

#include <map>
#include <stdexcept>

namespace lambent::report {
namespace {

using Quantity = std::optional<std::string> (*)(ReportContext&, const MeasuredShot&);

std::optional<std::string> mean_luminance(ReportContext& context, const MeasuredShot& measured)
{
    return percent(compare::displayed_luminance(context.renderer.codes(measured.shot)));
}

// Empty where the order is kept everywhere.
std::optional<std::string> hue_order_kept(ReportContext& context, const MeasuredShot& measured)
{
    const double kept = compare::kept_hue_order(context.renderer.codes(measured.shot),
                                                context.renderer.frame(measured.shot).radiance);
    return kept < 1.0 ? std::optional(percent(kept)) : std::nullopt;
}

std::optional<std::string> saturation_shown(ReportContext& context, const MeasuredShot& measured)
{
    return percent(saturation(context.renderer, measured.shot));
}

// The difference from the same shot with the tone curve after the light.
std::optional<std::string> difference_from_light(ReportContext& context, const MeasuredShot& measured)
{
    Values values = measured.values;
    values["way"] = "light";
    const Shot light = shot_of(context.content, measured.figure, values);
    return percent(code_difference(context.renderer, measured.shot, light));
}

// The structure of a few pixels' size that the converged shot does not have.
std::optional<std::string> blockiness(ReportContext& context, const MeasuredShot& measured)
{
    const Shot limit = converged_shot_of(context.content, measured.figure, measured.values);
    return percent(compare::fine_difference(context.renderer.frame(measured.shot).radiance,
                                            context.renderer.frame(limit).radiance));
}

// The spread of luminance on the sphere drawn without its ground.
std::optional<std::string> spread_on_sphere(ReportContext& context, const MeasuredShot& measured)
{
    Shot alone = measured.shot;
    alone.words.replace(0, alone.words.find(' '), "sphere");
    return percent(compare::luminance_spread(context.renderer.frame(alone).radiance));
}

Oval oval_of(ReportContext& context, const Shot& shot)
{
    return highlight_shape(context.renderer.frame(shot).radiance, context.renderer.camera(shot));
}

std::optional<std::string> highlight_on_plane(ReportContext& context, const MeasuredShot& measured)
{
    return rounded(oval_of(context, measured.shot).on_ground) + " : 1";
}

std::optional<std::string> highlight_in_picture(ReportContext& context, const MeasuredShot& measured)
{
    return rounded(oval_of(context, measured.shot).in_picture) + " : 1";
}

std::optional<std::string> difference_from_passes(ReportContext& context, const MeasuredShot& measured)
{
    return rounded(worst_difference(context.renderer.layers(measured.shot)));
}

const std::map<std::string, Quantity> quantities = {
    {"mean luminance", mean_luminance},
    {"hue order kept", hue_order_kept},
    {"saturation", saturation_shown},
    {"difference from light", difference_from_light},
    {"blockiness", blockiness},
    {"spread on the sphere", spread_on_sphere},
    {"highlight on the plane", highlight_on_plane},
    {"highlight in the picture", highlight_in_picture},
    {"difference from the passes", difference_from_passes},
};

} // namespace

bool is_quantity(const std::string& name)
{
    return quantities.contains(name);
}

std::optional<std::string> measured(ReportContext& context, const std::string& quantity,
                                    const MeasuredShot& shot)
{
    const auto found = quantities.find(quantity);
    if (found == quantities.end())
        throw std::logic_error(text("unknown quantity \"", quantity, "\""));
    return found->second(context, shot);
}

void add_measurements(ReportContext& context, const MeasuredShot& shot, PagePicture& picture)
{
    for (const Measurement& measurement : shot.figure.measured) {
        if (!fits(measurement.where, shot.values))
            continue;
        if (std::optional<std::string> value = measured(context, measurement.quantity, shot))
            picture.numbers.push_back({measurement.name, std::move(*value)});
    }
}

} // namespace lambent::report
