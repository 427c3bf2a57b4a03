#include "apps/viewer/trace.h"

#include "apps/common/picture_file.h"
#include "apps/common/reference_setup.h"
#include "compare/color_map.h"
#include "compare/difference.h"
#include "compare/flip.h"
#include "compare/image_pair.h"

#include <utility>

namespace lambent::viewer {
namespace {

// The codes as numbers from 0 to 1, three channels.
image::RadianceImage as_values(const image::CodeImage& codes)
{
    const auto channels = static_cast<std::size_t>(codes.channels);
    image::RadianceImage values{codes.width, codes.height, 3, {}};
    values.values.reserve(codes.bytes.size() / channels * 3);
    for (std::size_t i = 0; i < codes.bytes.size(); i += channels)
        for (std::size_t c = 0; c < 3; ++c)
            values.values.push_back(static_cast<float>(codes.bytes[i + c]) / 255.0f);
    return values;
}

} // namespace

Trace::Trace(TraceTask task, image::RadianceImage drawn) : task_(std::move(task)), drawn_(std::move(drawn)) {}

bool Trace::advance(const reference::GoOn& go_on)
{
    if (!tracing_) {
        cli::ReferenceArguments reference;
        reference.picture = task_.arguments;
        task_.model->pose(task_.arguments);
        scene_ = task_.model->whole_scene();
        reference::Settings settings = cli::reference_settings(reference, *scene_);
        settings.camera = task_.arguments.settings.camera;
        const std::optional<image::RadianceImage>& panorama = task_.environment->panorama;
        tracing_.emplace(*scene_, panorama ? &*panorama : nullptr, settings);
    }
    finished_ = tracing_->advance(go_on, reference::Least::nothing);
    return finished_;
}

ShownPicture Trace::picture() const
{
    const reference::Result result = tracing_->result();
    ShownPicture picture;
    picture.kind = ShownPicture::Kind::traced;
    picture.is_last = finished_;
    picture.traced = ShownPicture::Traced{result.samples, std::nullopt, 0.0, std::nullopt};
    if (result.noise)
        picture.traced->noise = result.noise->covered;
    // Both are clamped as a display does: a visible light source would otherwise dominate the error.
    image::RadianceImage drawn = drawn_, traced = result.radiance;
    for (image::RadianceImage* image : {&drawn, &traced}) {
        compare::expose(*image, task_.arguments.display.exposure);
        compare::clamp(*image, 1.0f);
    }
    picture.traced->error = compare::difference({drawn, traced}, 1.0).relative_rmse;
    const bool transparent = task_.arguments.settings.background.kind == draw::Background::Kind::none;
    picture.codes =
        cli::picture_codes(result.radiance, task_.arguments.display, transparent && !task_.shows_error);
    if (task_.shows_error)
        picture.codes = error_codes(picture.codes, *picture.traced);
    return picture;
}

image::CodeImage Trace::error_codes(const image::CodeImage& traced, ShownPicture::Traced& numbers) const
{
    const image::RadianceImage drawn = as_values(cli::picture_codes(drawn_, task_.arguments.display, false));
    const compare::ErrorMap map = compare::ldr_flip({drawn, as_values(traced)});
    numbers.flip = compare::mean(map);
    image::CodeImage codes{map.width, map.height, 3, 8, {}};
    codes.bytes.reserve(3 * map.values.size());
    for (const float error : map.values)
        for (const std::uint8_t code : compare::color_of(error))
            codes.bytes.push_back(code);
    return codes;
}

} // namespace lambent::viewer
