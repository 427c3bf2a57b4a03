#include "apps/options/arguments.h"

#include "apps/options/bake_grammar.h"
#include "apps/options/compare_grammar.h"
#include "apps/options/grammar.h"
#include "apps/options/picture_grammar.h"
#include "apps/options/report_grammar.h"
#include "apps/options/serve_grammar.h"
#include "apps/options/values.h"
#include "base/version.h"
#include "apps/options/view_grammar.h"
#include "base/error.h"
#include "base/text.h"

#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace lambent::cli {
namespace {

// Words as given; the parsing fills these, and an empty one was not given.
struct Words : CommonWords {
    std::string size, sun, turbidity;
    std::string bounces, spp, noise, time, seed;
};

const char* const about =
    "Physically based and image based lighting: pictures of models under the light of real places.";
const char* const footer =
    "SCENE: a .gltf or .glb file, or sphere, teapot, plane, report, painted, grid, furnace.\n"
    "'lambent help COMMAND' lists a command's options, which follow it.";

void add_output(Command& app, std::string& output, const std::string& help)
{
    app.add_required("-o,--output", output, "FILE", help);
}

ReferenceArguments finished(const Words& words, ReferenceArguments arguments)
{
    if (arguments.picture.backend == Backend::vulkan)
        throw Error(Failure::usage,
                    "--backend: vulkan draws, but does not trace: references are made by cpu");
    if (!words.bounces.empty())
        arguments.bounces = whole_in(words.bounces, "--bounces", 0, 1024);
    if (!words.spp.empty())
        arguments.samples = whole_in(words.spp, "--spp", 1, 1 << 20);
    if (!arguments.variance.empty() && arguments.samples == 1)
        throw Error(Failure::usage, "--variance: one sample per pixel tells none: --spp 2 or more");
    if (!words.noise.empty())
        arguments.noise = static_cast<double>(number_in(words.noise, "--noise", 1e-6, 1.0));
    if (!words.time.empty())
        arguments.seconds = static_cast<double>(positive(words.time, "--time"));
    if (!words.seed.empty())
        arguments.seed = static_cast<std::uint32_t>(whole_in(words.seed, "--seed", 0, 1 << 30));
    return arguments;
}

EnvArguments finished(const Words& words, EnvArguments arguments)
{
    arguments.common = common_options(words);
    environment::BuiltinOptions& options = arguments.builtin;
    if (!words.size.empty()) {
        const Size size = parse_size(words.size, "--size");
        if (size.width != 2 * size.height)
            throw Error(Failure::usage, text("--size: ", words.size, " is not twice as wide as high"));
        options.width = size.width;
    }
    if (!words.sun.empty()) {
        const std::vector<double> sun = parse_list(words.sun, {2, 2}, "--sun");
        if (sun[1] < -5.7 || sun[1] > 90.0)
            throw Error(Failure::usage,
                        text("--sun: ", words.sun, ": the elevation is not from -5.7 to 90 degrees"));
        options.sun_azimuth = radians(std::remainder(sun[0], 360.0));
        options.sun_elevation = radians(sun[1]);
    }
    if (!words.turbidity.empty())
        options.turbidity = number_in(words.turbidity, "--turbidity", 1.5, 10.0);
    return arguments;
}

// The whole grammar, and where its words go.
struct Grammar {
    CommandLine line{{"lambent", about, text("lambent ", version), footer}};
    Words words;
    PictureGrammar picture;               ///< of render, or of reference
    std::string output, layers, pipeline; ///< the last two of render
    ReferenceArguments reference;
    EnvArguments env;
    InfoArguments info;
    BakeGrammar bake;
    CompareGrammar compare;
    ReportGrammar report;
    ViewGrammar view;
    ServeGrammar serve;
    Command render_command, reference_command, env_command, info_command;

    /// Of all commands; for `render` of that alone, as viewers ask for it many times a second.
    explicit Grammar(std::string_view command)
    {
        Command app = line.program();
        add_render(app);
        if (command != "render")
            add_others(app);
    }

    void add_others(Command& app)
    {
        bake.add(app);
        add_reference(app);
        compare.add(app);
        report.add(app);
        view.add(app);
        serve.add(app);
        add_env(app);
        add_info(app);
    }

    void add_render(Command& app)
    {
        render_command = app.add_subcommand("render", "Draw a picture of a scene");
        add_picture(render_command);
        option(render_command, "--layers", layers, "DIR",
               "Also write each layer of the G-buffer and of the light");
        option(render_command, "--pipeline", pipeline, "WHOSE",
               "light, added up and then shown, or the 2014 report's own (light)");
    }

    void add_reference(Command& app)
    {
        reference_command = app.add_subcommand("reference", "The same picture, path-traced");
        add_picture(reference_command);
        Command command = reference_command.under("Tracing");
        option(command, "--bounces", words.bounces, "N",
               "Bounces of light; 0: direct light without shadows, 1: with shadows (8)");
        option(command, "--spp", words.spp, "N", "Stop at N samples per pixel (1024, if no limit is given)");
        option(command, "--noise", words.noise, "REL",
               "Stop at this estimated relative error of what surfaces cover (0.01, if no limit is given)");
        option(command, "--time", words.time, "S", "Stop after S seconds");
        option(command, "--seed", words.seed, "N", "Another number, other noise (0)");
        option(command, "--variance", reference.variance, "FILE",
               "Also write the variance of each value: .exr or .hdr");
        command.add_flag("--uniform", reference.uniform,
                         "As many samples for every pixel; so with --spp alone");
    }

    void add_picture(Command& command)
    {
        picture.add(command);
        add_output(command, output, "The picture: .png .jpg (as displayed), .exr .hdr (linear radiance)");
    }

    RenderArguments picture_result() const
    {
        RenderArguments arguments = picture.result();
        if (!pipeline.empty() && choose<bool>(pipeline, "--pipeline", {{"light", false}, {"report", true}}))
            picture.use_report_pipeline(arguments);
        arguments.output = output;
        arguments.layers = layers;
        return arguments;
    }

    void add_env(Command& app)
    {
        env_command = app.add_subcommand("env", "Write a built-in environment");
        Command& command = env_command;
        command.add_required("name", env.name, "NAME", "kitchen, studio, sky or furnace");
        add_output(command, env.output, "The panorama: .hdr or .exr");
        option(command, "--size", words.size, "WxH",
               "Size in texels, twice as wide as high (1024x512; kitchen 2048x1024)");
        option(command, "--sun", words.sun, "AZ,EL",
               "sky: where the sun stands, degrees, as --camera (-46,40)");
        option(command, "--turbidity", words.turbidity, "T", "sky: haze, 1.5 to 10 (2.2)");
        add_common(command, words);
    }

    void add_info(Command& app)
    {
        info_command = app.add_subcommand("info", "Say what is in a glTF or an image");
        Command& command = info_command;
        command.add_required("file", info.file, "FILE", "A .gltf, .glb, .hdr, .exr, .png or .jpg");
        command.add_flag("--json", info.json, "As one JSON object");
        add_common(command, words);
    }

    Arguments result()
    {
        if (render_command.parsed())
            return picture_result();
        if (reference_command.parsed()) {
            reference.picture = picture_result();
            return finished(words, reference);
        }
        if (bake.parsed())
            return bake.result();
        if (compare.parsed())
            return compare.result();
        if (report.parsed())
            return report.result();
        if (view.parsed())
            return view.result();
        if (serve.parsed())
            return serve.result();
        if (env_command.parsed())
            return finished(words, env);
        info.common = common_options(words);
        return info;
    }
};

} // namespace

Arguments parse_arguments(int count, const char* const* words)
{
    if (count < 2)
        throw Error(Failure::usage, "no command given; lambent --help lists them");
    Grammar grammar(words[1]);
    if (const std::optional<std::string> asked_for = grammar.line.parse(count, words))
        return PrintText{*asked_for};
    return grammar.result();
}

} // namespace lambent::cli
