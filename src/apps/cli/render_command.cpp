#include "apps/cli/commands.h"
#include "apps/common/console.h"
#include "apps/common/layer_files.h"
#include "apps/common/load_environment.h"
#include "apps/common/make_renderer.h"
#include "apps/common/picture_audit.h"
#include "apps/common/picture_file.h"
#include "apps/common/picture_setup.h"
#include "apps/common/refined_picture.h"
#include "apps/common/stats.h"
#include "apps/common/stopwatch.h"
#include "apps/common/threads.h"
#include "base/text.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace lambent::cli {
namespace {

nlohmann::ordered_json describe(const RenderArguments& arguments, const scene::Scene& scene,
                                const draw::Renderer& renderer)
{
    const draw::Renderer::Device device = renderer.device();
    return {{"command", "render"},
            {"scene", arguments.scene},
            {"environment", arguments.environment},
            {"output", arguments.output},
            {"backend", device.backend},
            {"device", device.description},
            {"width", arguments.settings.width},
            {"height", arguments.settings.height},
            {"samples", arguments.settings.samples},
            {"bounces", arguments.settings.bounces},
            {"triangles", scene::triangle_count(scene)}};
}

// Layers must not have the path of an input or of the picture.
void check_layer_files(const std::vector<draw::Layer>& layers, const RenderArguments& arguments,
                       const InputFiles& inputs)
{
    for (const std::filesystem::path& file : layer_files(layers, arguments.layers)) {
        inputs.keep_from(file);
        check_two_outputs(arguments.output, file);
    }
}

// A picture is worth having where its error cannot be measured.
std::optional<audit::Error> measured(const RenderArguments& arguments, const scene::Scene& scene,
                                     const image::RadianceImage& picture, Console& console)
{
    std::optional<audit::Error> error;
    try {
        error = PictureAudit(arguments, scene).error_of(picture, 0);
    } catch (const Error& failure) {
        if (failure.failure() != Failure::no_device)
            throw;
        console.warn({text("the picture's error is not measured: ", failure.what())});
    }
    return error;
}

struct Drawn {
    draw::Frame frame;
    int passes;
    std::optional<audit::Error> error; ///< unset: not measured yet
};

// Refines the picture until it is as good as asked or the time is over.
Drawn draw_refined(const RenderArguments& arguments, const scene::Scene& scene,
                   std::unique_ptr<draw::Drawing> drawing, int passes, Console& console)
{
    const RefineLimits limits{arguments.error, arguments.seconds};
    std::optional<PictureAudit> audit;
    if (limits.error)
        audit.emplace(arguments, scene);
    RefinedPicture refined = refined_picture(
        std::move(drawing), passes, limits,
        [&](const image::RadianceImage& picture, std::uint32_t number) {
            return audit->error_of(picture, number);
        },
        [&](float done, const std::optional<audit::Error>& error) {
            console.progress(done, error ? in_words(*error) : "");
        });
    console.end_progress();
    if (limits.error && refined.error && refined.error->relative_rmse > *limits.error) {
        console.warn({text("--error: ", *limits.error, " is not reached after ", refined.passes,
                           " passes: ", in_words(*refined.error))});
        refined.error.reset(); // it was measured on the way, not at the end
    }
    console.remark(text("--passes ", refined.passes, " draws the same picture"));
    return {std::move(refined.frame), refined.passes, refined.error};
}

Drawn draw(const RenderArguments& arguments, const scene::Scene& scene,
           const environment::Environment* environment, draw::Renderer& renderer, Console& console)
{
    draw::Settings settings = arguments.settings;
    settings.camera = choose_camera(arguments, scene);
    settings.lights = lights_asked(arguments, scene.origin);
    settings.layers = !arguments.layers.empty();
    if (arguments.seconds)
        settings.passes = 1;
    if (arguments.error || arguments.seconds)
        return draw_refined(arguments, scene, renderer.start(environment, settings), settings.passes,
                            console);
    draw::Frame frame = renderer.draw(environment, settings, [&](float done) { console.progress(done); });
    console.end_progress();
    return {std::move(frame), settings.passes, {}};
}

void write(const RenderArguments& arguments, const draw::Frame& frame, const InputFiles& inputs,
           const image::Notes& notes)
{
    using Kind = draw::Background::Kind;
    const bool transparent = arguments.settings.background.kind == Kind::none;
    // The picture is written last: if it exists, everything succeeded.
    if (!arguments.layers.empty()) {
        check_layer_files(frame.layers, arguments, inputs);
        write_layers(frame.layers, arguments.layers, arguments.display);
    }
    write_picture(frame.radiance, arguments.display, transparent, arguments.output, notes);
}

} // namespace

void run(const RenderArguments& arguments)
{
    check_picture_file(arguments.output);
    InputFiles inputs = inputs_named(arguments);
    inputs.keep_from(arguments.output);
    if (!arguments.layers.empty())
        make_layer_folder(arguments.layers);
    const ThreadLimit limit(arguments.common.threads);
    Console console(arguments.common.verbosity);
    Stopwatch watch;
    Warnings warnings;
    const scene::Scene scene = load_scene(arguments, warnings, &inputs);
    inputs.keep_from(arguments.output);
    watch.lap("scene");
    const LoadedEnvironment loaded = load_environment(arguments.environment, arguments.cache);
    warnings.insert(warnings.end(), loaded.warnings.begin(), loaded.warnings.end());
    watch.lap("environment");
    console.warn_of_input(warnings, arguments.common);
    console.remark(text(arguments.scene, ": ", scene::triangle_count(scene), " triangles, ",
                        scene.materials.size(), " materials, ", scene.images.size(), " textures"));

    const Backend backend = arguments.settings.bounces > 0 ? Backend::cpu : arguments.backend;
    const std::unique_ptr<draw::Renderer> renderer = make_renderer(
        {backend, arguments.cache, [&](const std::string& line) { console.warn({line}); }}, scene);
    const Drawn drawn =
        draw(arguments, scene, loaded.environment ? &*loaded.environment : nullptr, *renderer, console);
    watch.lap("draw");
    std::optional<audit::Error> error;
    if (is_audited(arguments)) {
        error = drawn.error;
        if (!error)
            error = measured(arguments, scene, drawn.frame.radiance, console);
        if (error)
            console.remark(in_words(*error));
        watch.lap("audit");
    }
    write(arguments, drawn.frame, inputs, error ? notes_of(*error) : image::Notes());
    watch.lap("write");
    console.remark(text("wrote ", arguments.output));
    if (arguments.common.stats_json) {
        nlohmann::ordered_json stats = describe(arguments, scene, *renderer);
        if (arguments.settings.bounces > 0)
            stats["passes"] = drawn.passes;
        if (is_audited(arguments))
            stats["error"] = error ? to_json(*error) : nlohmann::ordered_json(nullptr);
        stats["environment_cached"] = loaded.cached;
        for (const auto& [pass, milliseconds] : drawn.frame.passes)
            stats["device_ms"][pass] = milliseconds;
        add_cost(watch, stats);
        print(stats);
    }
}

} // namespace lambent::cli
