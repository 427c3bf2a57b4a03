#include "apps/options/rules.h"

#include "apps/options/option_table.h"
#include "base/error.h"
#include "base/text.h"

namespace lambent::cli {
namespace {

template <class... Parts>
void refuse_if(bool refused, const Parts&... reason)
{
    if (refused)
        throw Error(Failure::usage, text(reason...));
}

void check_view(const RenderArguments& arguments, const Given& given)
{
    const bool has_node = given("camera-node");
    refuse_if(has_node && given("camera"), "--camera and --camera-node exclude each other");
    refuse_if(given("target") && !(arguments.orbit && arguments.orbit->distance > 0.0f),
              "--target: only with --camera AZ,EL,DIST");
    refuse_if(has_node && given("fov"),
              "--fov and --camera-node exclude each other: a camera has its own field of view");
}

// Sets up the report's own pipeline; refuses options that it cannot follow.
void settle_pipeline(RenderArguments& arguments, const Given& given)
{
    draw::Settings& settings = arguments.settings;
    display::Settings& display = arguments.display;
    refuse_if(settings.model != draw::Model::phong, "--pipeline report: only with --model phong");
    refuse_if(given("mip-level") && settings.mip_level != draw::MipLevel::report,
              "--pipeline report: not with --mip-level matched: it uses the report's own levels");
    refuse_if(display.tone != display::Tone::reinhard,
              "--pipeline report: not with --tone: it uses the report's own tone curve");
    refuse_if(given("audit"), "--pipeline report: not with --audit: no reference draws as it does");
    settings.pipeline = draw::ReportPipeline{display.exposure, display.contrast, display.encode};
    settings.mip_level = draw::MipLevel::report;
    settings.texel_transfer = draw::TexelTransfer::none; // the pipeline decodes texels itself
    if (!given("ambient-brightness"))
        settings.ambient_brightness = 2.0f;
    // The pipeline draws code values, which the display must not change.
    display.exposure = display.contrast = 1.0f;
    display.tone = display::Tone::linear;
    display.encode = false;
}

void check_bounces(const RenderArguments& arguments, const Given& given)
{
    const bool bounces = arguments.settings.bounces > 0;
    refuse_if(given("bounces") && arguments.bounces > 0 && draws_as_report(arguments),
              arguments.report_pipeline                                ? "--pipeline report"
              : arguments.settings.mip_level == draw::MipLevel::report ? "--mip-level report"
                                                                       : "--ambient-brightness",
              ": only with --bounces 0: the 2014 report has no shadows");
    refuse_if(bounces && arguments.backend == Backend::vulkan,
              "--backend vulkan: draws light without shadows only; use --backend cpu or --bounces 0");
    for (const char* const name : {"passes", "error", "time"})
        refuse_if(!bounces && given(name), "--", name, ": only with --bounces above 0");
    refuse_if(given("passes") && (given("error") || given("time")),
              "--passes: not with --error or --time, which choose the number of passes");
    refuse_if(given("error") && given("no-audit"), "--error: not with --no-audit: the error is measured");
}

} // namespace

// The report's pipeline draws codes, which are not the light of any reference.
bool is_audited(const RenderArguments& arguments)
{
    return !arguments.settings.pipeline &&
           (arguments.audit_always || (arguments.audit && arguments.settings.bounces > 0));
}

bool draws_as_report(const RenderArguments& arguments)
{
    return arguments.report_pipeline || arguments.settings.mip_level == draw::MipLevel::report ||
           arguments.settings.ambient_brightness != 1.0f;
}

void derive(RenderArguments& arguments)
{
    draw::Settings& settings = arguments.settings;
    settings.bounces = draws_as_report(arguments) ? 0 : arguments.bounces;
    settings.white = 1.0f / arguments.display.exposure;
    if (arguments.split_sum)
        settings.samples = draw::split_sum_samples;
    // The report decodes its texels by the power that it encodes with; glTF's are sRGB.
    using draw::TexelTransfer;
    settings.texel_transfer = !arguments.display.encode              ? TexelTransfer::none
                              : settings.model == draw::Model::phong ? TexelTransfer::power_2_2
                                                                     : TexelTransfer::srgb;
    arguments.display.unlit_by_power = settings.texel_transfer == TexelTransfer::power_2_2;
}

void settle(CommonOptions&, const Given& given)
{
    refuse_if(given("quiet") && given("verbose"), "--quiet and --verbose exclude each other");
}

void settle(RenderArguments& arguments, const Given& given)
{
    check_view(arguments, given);
    refuse_if(given("audit") && given("no-audit"), "--audit and --no-audit exclude each other");
    derive(arguments);
    check_bounces(arguments, given);
    if (arguments.report_pipeline)
        settle_pipeline(arguments, given);
}

void settle(ReferenceArguments& arguments, const Given& given)
{
    check_view(arguments.picture, given);
    derive(arguments.picture);
    refuse_if(arguments.picture.backend == Backend::vulkan,
              "--backend vulkan: references are path-traced on the CPU only");
    refuse_if(arguments.denoise && !arguments.variance.empty(),
              "--denoise: not with --variance, which is that of the picture without the filter");
    refuse_if(given("no-audit") && !arguments.denoise, "--no-audit: only with --denoise");
    refuse_if(!arguments.variance.empty() && arguments.samples == 1,
              "--variance: needs two samples per pixel or more: --spp 2");
}

void settle(StartArguments& arguments, const Given& given)
{
    settle(arguments.picture, given);
    arguments.given = given;
    refuse_if(arguments.picture.common.stats_json,
              "--stats: not with view and serve, which run until they are closed");
}

void settle(CompareArguments& arguments, const Given& given)
{
    refuse_if(given("heat") && arguments.output.empty(), "--heat: only with -o");
}

void settle(ReportArguments& arguments, const Given& given)
{
    const int width = arguments.width, height = arguments.height;
    refuse_if(arguments.output.empty(), "--output: the name is empty");
    refuse_if(arguments.environment == "none", "--env: a report needs an environment");
    refuse_if(arguments.quick && (given("noise") || given("spp")),
              "--quick: not with --noise or --spp, which are limits of references");
    refuse_if(width < 16 || height < 16 || width > 4096 || height > 4096,
              "--size: ", size_word({width, height}), " is outside of 16x16 to 4096x4096");
}

} // namespace lambent::cli
