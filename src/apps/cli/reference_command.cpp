#include "apps/cli/commands.h"
#include "apps/common/console.h"
#include "apps/common/denoise_reference.h"
#include "apps/common/interrupt.h"
#include "apps/common/picture_audit.h"
#include "apps/common/picture_file.h"
#include "apps/common/picture_setup.h"
#include "apps/common/reference_setup.h"
#include "apps/common/stats.h"
#include "apps/common/stopwatch.h"
#include "apps/common/threads.h"
#include "base/file.h"
#include "base/text.h"
#include "image/files/image_io.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <optional>

namespace lambent::cli {
namespace {

std::string percent(double share)
{
    char shown[40];
    std::snprintf(shown, sizeof shown, "%.2f%%", 100.0 * share);
    return shown;
}

std::string note_of(const reference::Progress& progress)
{
    if (!(progress.samples > 0.0))
        return "";
    const std::string samples = text(std::lround(progress.samples), " samples");
    return progress.noise ? text(samples, ", noise ", percent(progress.noise->covered)) : samples;
}

void check_variance_file(const std::string& path)
{
    if (path.empty())
        return;
    const image::FileKind kind = image::file_kind(path);
    if (kind != image::FileKind::exr && kind != image::FileKind::hdr)
        throw Error(Failure::usage, text("--variance: ", path, ": its name ends in .exr or .hdr"));
    check_can_write(path);
}

using Json = nlohmann::ordered_json;

void check_outputs(const ReferenceArguments& arguments, const InputFiles& inputs)
{
    inputs.keep_from(arguments.picture.output);
    if (arguments.variance.empty())
        return;
    inputs.keep_from(arguments.variance);
    check_two_outputs(arguments.picture.output, arguments.variance);
}

Json describe(const ReferenceArguments& arguments, const scene::Scene& scene, const reference::Result& result)
{
    return {{"command", "reference"},
            {"scene", arguments.picture.scene},
            {"environment", arguments.picture.environment},
            {"output", arguments.picture.output},
            {"backend", "cpu"},
            {"width", result.radiance.width},
            {"height", result.radiance.height},
            {"bounces", arguments.picture.bounces},
            {"samples", result.samples},
            {"error", result.noise ? Json(result.noise->all) : Json(nullptr)},
            {"error_covered", result.noise ? Json(result.noise->covered) : Json(nullptr)},
            {"error_cut", 1.0},
            {"triangles", scene::triangle_count(scene)}};
}

Warnings warnings_of(const reference::Result& result)
{
    Warnings warnings;
    if (result.stopped)
        warnings.push_back(text("stopped early, at ", result.samples, " samples per pixel",
                                result.noise ? text(" and ", percent(result.noise->covered), " noise")
                                             : std::string(" and unknown noise")));
    if (result.broken > 0)
        warnings.push_back(text(result.broken, " samples are not finite and count as black"));
    return warnings;
}

// What was traced, and how.
struct Traced {
    const ReferenceArguments& arguments;
    const reference::Settings& settings;
    const scene::Scene& scene;
    const std::optional<image::RadianceImage>& environment;
};

// A picture without its noise, and its measured error.
struct Filtered {
    image::RadianceImage picture;
    std::optional<audit::Error> error;
};

Filtered filter(const Traced& traced, const reference::Result& result, const Console& console,
                Stopwatch& watch)
{
    Filtered filtered{denoised(result), std::nullopt};
    watch.lap("denoise");
    if (!traced.arguments.audit)
        return filtered;
    filtered.error = measured_error(traced.settings, traced.scene,
                                    traced.environment ? &*traced.environment : nullptr, filtered.picture);
    watch.lap("audit");
    if (filtered.error)
        console.remark(result.noise ? text(in_words(*filtered.error), "; noise before the filter ",
                                           percent(result.noise->covered))
                                    : in_words(*filtered.error));
    return filtered;
}

} // namespace

void run(const ReferenceArguments& arguments)
{
    const RenderArguments& picture = arguments.picture;
    check_picture_file(picture.output);
    check_variance_file(arguments.variance);
    InputFiles inputs = inputs_named(picture);
    check_outputs(arguments, inputs);
    const Interrupt interrupt; // before files are loaded, so that Ctrl-C counts during loading too
    const ThreadLimit limit(picture.common.threads);
    Console console(picture.common.verbosity);
    Stopwatch watch;
    Warnings warnings;
    const scene::Scene scene = load_scene(picture, warnings, &inputs);
    check_outputs(arguments, inputs);
    watch.lap("scene");
    const std::optional<image::RadianceImage> environment =
        load_raw_environment(picture.environment, warnings);
    watch.lap("environment");
    console.warn_of_input(warnings, picture.common);

    const reference::Settings settings = reference_settings(arguments, scene);
    const reference::Result result = reference::trace(
        scene, environment ? &*environment : nullptr, settings,
        [&](const reference::Progress& progress) {
            console.progress(static_cast<float>(progress.done), note_of(progress));
            return !interrupt.asked();
        },
        arguments.variance.empty() ? reference::Least::one_sample : reference::Least::two_samples);
    console.end_progress();
    console.warn(warnings_of(result));
    watch.lap("trace");
    if (!arguments.variance.empty())
        image::write_radiance(result.variance, arguments.variance);
    const Filtered filtered = arguments.denoise
                                  ? filter({arguments, settings, scene, environment}, result, console, watch)
                                  : Filtered();
    const bool transparent = settings.background.kind == view::Background::Kind::none;
    write_picture(arguments.denoise ? filtered.picture : result.radiance, picture.display, transparent,
                  picture.output, filtered.error ? notes_of(*filtered.error) : image::Notes());
    watch.lap("write");
    console.remark(text("wrote ", picture.output));
    if (picture.common.stats_json) {
        Json stats = describe(arguments, scene, result);
        if (arguments.denoise && arguments.audit)
            stats["denoised_error"] = filtered.error ? to_json(*filtered.error) : Json(nullptr);
        add_cost(watch, stats);
        print(stats);
    }
}

} // namespace lambent::cli
