#include "apps/common/picture_audit.h"

#include "apps/common/reference_setup.h"
#include "base/text.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace lambent::cli {
namespace {

std::string digits(const char* format, double value)
{
    char shown[40];
    std::snprintf(shown, sizeof shown, format, value);
    return shown;
}

std::string in_percent(double share)
{
    return digits(100.0 * share < 9.95 ? "%.2g" : "%.0f", 100.0 * share);
}

} // namespace

PictureAudit::PictureAudit(const RenderArguments& arguments, const scene::Scene& scene)
{
    ReferenceArguments asked;
    asked.picture = arguments;
    asked.picture.bounces = arguments.settings.bounces;
    const reference::Settings truth = reference_settings(asked, scene);
    Warnings repeated; // by the reader of the environment that was drawn
    panorama_ = load_raw_environment(arguments.environment, repeated);
    cut_ = truth.cut;
    tracer_ = std::make_unique<reference::PixelTracer>(scene, panorama_ ? &*panorama_ : nullptr, truth);
}

std::optional<audit::Error> PictureAudit::error_of(const image::RadianceImage& picture, std::uint32_t number,
                                                   const std::function<void()>& before_each) const
{
    audit::Settings settings;
    settings.cut = cut_;
    settings.seed = number;
    return audit::measure(picture, settings, [&](const reference::PixelTracer::Pixel& pixel) {
        if (before_each)
            before_each();
        return tracer_->estimate(pixel);
    });
}

std::optional<audit::Error> measured_error(const reference::Settings& truth, const scene::Scene& scene,
                                           const image::RadianceImage* panorama,
                                           const image::RadianceImage& picture)
{
    audit::Settings settings;
    settings.cut = truth.cut;
    return audit::measure(scene, panorama, truth, picture, settings);
}

std::string in_words(const audit::Error& error)
{
    return text("error ", in_percent(error.relative_rmse), " % (", in_percent(error.low), " to ",
                in_percent(error.high), ")");
}

image::Notes notes_of(const audit::Error& error)
{
    return {{"lambent.error", text(digits("%.4g", error.relative_rmse), " ", digits("%.4g", error.low), " ",
                                   digits("%.4g", error.high))}};
}

nlohmann::ordered_json to_json(const audit::Error& error)
{
    return {{"relative_rmse", error.relative_rmse},
            {"low", error.low},
            {"high", error.high},
            {"confidence", error.confidence},
            {"pixels", error.pixels}};
}

} // namespace lambent::cli
