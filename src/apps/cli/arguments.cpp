#include "apps/cli/arguments.h"

#include "apps/cli/bake_grammar.h"
#include "apps/cli/compare_grammar.h"
#include "apps/cli/grammar.h"
#include "apps/cli/report_grammar.h"
#include "apps/cli/serve_grammar.h"
#include "apps/cli/values.h"
#include "apps/cli/version.h"
#include "apps/cli/view_grammar.h"
#include "base/error.h"
#include "base/text.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace lambent::cli {
namespace {

// Words as given; CLI11 fills these, and an empty one was not given.
struct Words : CommonWords {
    std::string size, camera, target, fov, aa;
    std::string rotation, background, ambient, ibl, samples;
    std::string model, mip_level, alpha, kd, ks, density;
    std::string exposure, contrast, tone, space;
    std::string backend, sun, turbidity;
    std::string bounces, spp, noise, time, seed;
    std::vector<std::string> lights;
    bool no_cache = false, no_compensation = false;
};

void add_view(CLI::App& app, RenderArguments& arguments, Words& words)
{
    option(app, "--size", words.size, "WxH", "Picture size in pixels (1280x720)");
    option(app, "--camera", words.camera, "AZ,EL[,DIST]",
           "Degrees around and above the scene, metres from its middle (frames it)");
    option(app, "--target", words.target, "X,Y,Z",
           "The point that --camera, with a distance, is around, metres (the scene's middle)");
    option(app, "--camera-node", arguments.camera_node, "NAME", "A camera of the glTF");
    option(app, "--fov", words.fov, "DEG", "Vertical field of view (45)");
    option(app, "--aa", words.aa, "N", "Samples per pixel where surfaces end (4)");
}

void add_light(CLI::App& app, RenderArguments& arguments, Words& words)
{
    option(app, "--env", arguments.environment, "ENV",
           "A panorama (.hdr, .exr), or kitchen, studio, sky, furnace, none (kitchen)");
    option(app, "--env-rotation", words.rotation, "DEG", "Turn the environment about the vertical (0)");
    option(app, "--background", words.background, "KIND", "env, none, R,G,B or blur:ROUGHNESS (env)");
    app.add_option("--light", words.lights,
                   "directional:AZ,EL,R,G,B (lux) or point:X,Y,Z,R,G,B (candela); repeatable")
        ->type_name("LIGHT")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->expected(1)
        ->allow_extra_args(false);
    option(app, "--ambient-brightness", words.ambient, "B",
           "Factor on diffuse environment light (1; the report's is 2)");
    option(app, "--ibl", words.ibl, "METHOD",
           "Specular environment light: sampled, or split-sum, 8 samples (sampled)");
    option(app, "--samples", words.samples, "N", "Samples of the specular lobe (40)");
    app.add_flag("--no-cache", words.no_cache, "Neither read nor write the environment cache");
}

void add_material(CLI::App& app, Words& words)
{
    option(app, "--model", words.model, "MODEL", "ggx, as glTF, or phong, as the report (ggx)");
    option(app, "--mip-level", words.mip_level, "RULE",
           "phong: matched to the lobe, or the report's own choice, which shows blocks (matched)");
    option(app, "--alpha", words.alpha, "A", "phong, built-in shapes: exponent, above 0, at most 1e6");
    option(app, "--kd", words.kd, "R,G,B", "phong, built-in shapes: diffuse colour");
    option(app, "--ks", words.ks, "R,G,B", "phong, built-in shapes: specular colour");
    option(app, "--density", words.density, "X",
           "Built-in shapes: triangles along an edge, times the usual (1)");
    app.add_flag("--no-energy-compensation", words.no_compensation,
                 "ggx: leave out light scattered more than once");
}

void add_display(CLI::App& app, RenderArguments& arguments, Words& words)
{
    option(app, "--exposure", words.exposure, "E", "Factor on the light before the tone curve (1)");
    option(app, "--contrast", words.contrast, "K", "Power on the curve's result (1)");
    option(app, "--tone", words.tone, "CURVE", "reinhard, neutral, aces, agx or linear (reinhard)");
    option(app, "--space", words.space, "SPACE",
           "linear, or nonlinear: neither texels nor output converted (linear)");
    app.add_flag("--dither", arguments.display.dither, "Noise of one code against banding");
}

void apply_view(const Words& words, RenderArguments& arguments)
{
    if (!words.size.empty()) {
        const Size size = parse_size(words.size, "--size");
        arguments.settings.width = size.width;
        arguments.settings.height = size.height;
    }
    if (!words.camera.empty() && !arguments.camera_node.empty())
        throw Error(Failure::usage, "--camera and --camera-node exclude each other");
    if (!words.camera.empty())
        arguments.orbit = parse_orbit(words.camera, "--camera");
    if (!words.target.empty()) {
        if (!arguments.orbit || arguments.orbit->distance <= 0.0f)
            throw Error(Failure::usage, "--target: only with --camera AZ,EL,DIST");
        arguments.target = parse_point(words.target, "--target");
    }
    if (!words.fov.empty())
        arguments.vertical_fov = radians(number_in(words.fov, "--fov", 0.1, 175.0));
    if (!words.aa.empty())
        arguments.settings.edge_samples = whole_in(words.aa, "--aa", 1, 64);
}

void apply_light(const Words& words, RenderArguments& arguments)
{
    draw::Settings& settings = arguments.settings;
    if (!words.rotation.empty())
        settings.environment_rotation =
            radians(std::remainder(parse_number(words.rotation, "--env-rotation"), 360.0));
    if (!words.background.empty())
        settings.background = parse_background(words.background, "--background");
    for (const std::string& light : words.lights)
        settings.lights.push_back(parse_light(light, "--light"));
    if (!words.ambient.empty())
        settings.ambient_brightness = number_in(words.ambient, "--ambient-brightness", 0.0, 1.0e6);
    if (!words.samples.empty())
        settings.samples = whole_in(words.samples, "--samples", 1, 65536);
    if (!words.ibl.empty() && choose<bool>(words.ibl, "--ibl", {{"sampled", false}, {"split-sum", true}}))
        settings.samples = draw::split_sum_samples;
}

void apply_material(const Words& words, RenderArguments& arguments)
{
    using draw::Model, draw::MipLevel;
    draw::Settings& settings = arguments.settings;
    if (!words.model.empty())
        settings.model =
            choose<Model>(words.model, "--model", {{"ggx", Model::ggx}, {"phong", Model::phong}});
    if (!words.mip_level.empty())
        settings.mip_level = choose<MipLevel>(words.mip_level, "--mip-level",
                                              {{"matched", MipLevel::matched}, {"report", MipLevel::report}});
    settings.energy_compensation = !words.no_compensation;
    const bool phong = settings.model == Model::phong, built_in = scene::is_builtin(arguments.scene);
    for (const auto& [name, word] :
         {std::pair("--alpha", &words.alpha), {"--kd", &words.kd}, {"--ks", &words.ks}})
        if (!word->empty() && !(phong && built_in))
            throw Error(Failure::usage, text(name, ": only with --model phong and a built-in shape"));
    if (!words.density.empty() && !built_in)
        throw Error(Failure::usage, "--density: only with a built-in shape");
    if (!words.alpha.empty()) {
        arguments.builtin.exponent = positive(words.alpha, "--alpha");
        number_in(words.alpha, "--alpha", 0.0, 1.0e6);
    }
    if (!words.kd.empty())
        arguments.builtin.diffuse = parse_color(words.kd, "--kd");
    if (!words.ks.empty())
        arguments.builtin.specular = parse_color(words.ks, "--ks");
    if (!words.density.empty())
        arguments.builtin.density = number_in(words.density, "--density", 0.0625, 8.0);
}

void apply_display(const Words& words, RenderArguments& arguments)
{
    using display::Tone;
    display::Settings& settings = arguments.display;
    if (!words.exposure.empty())
        settings.exposure = positive(words.exposure, "--exposure");
    if (!words.contrast.empty())
        settings.contrast = positive(words.contrast, "--contrast");
    if (!words.tone.empty())
        settings.tone = choose<Tone>(words.tone, "--tone",
                                     {{"reinhard", Tone::reinhard},
                                      {"neutral", Tone::neutral},
                                      {"aces", Tone::aces},
                                      {"agx", Tone::agx},
                                      {"linear", Tone::linear}});
    if (!words.space.empty())
        settings.encode = choose<bool>(words.space, "--space", {{"linear", true}, {"nonlinear", false}});
    // The report decodes its texels by the power that it encodes with; glTF's are sRGB.
    using draw::TexelTransfer;
    const bool phong = arguments.settings.model == draw::Model::phong;
    arguments.settings.texel_transfer = !settings.encode ? TexelTransfer::none
                                        : phong          ? TexelTransfer::power_2_2
                                                         : TexelTransfer::srgb;
}

void add_output(CLI::App& app, std::string& output, const std::string& help)
{
    app.add_option("-o,--output", output, help)->type_name("FILE")->required();
}

RenderArguments finished(const Words& words, RenderArguments arguments)
{
    arguments.common = common_options(words);
    arguments.cache = !words.no_cache;
    apply_view(words, arguments);
    apply_light(words, arguments);
    apply_material(words, arguments);
    apply_display(words, arguments);
    if (!words.backend.empty())
        arguments.backend = choose_backend(words.backend);
    return arguments;
}

ReferenceArguments finished(const Words& words, ReferenceArguments arguments)
{
    arguments.picture = finished(words, arguments.picture);
    if (arguments.picture.backend == Backend::vulkan)
        throw Error(Failure::usage,
                    "--backend: vulkan draws, but does not trace: references are made by cpu");
    if (!words.bounces.empty())
        arguments.bounces = whole_in(words.bounces, "--bounces", 0, 1024);
    if (!words.spp.empty())
        arguments.samples = whole_in(words.spp, "--spp", 1, 1 << 20);
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
    CLI::App app{
        "Physically based and image based lighting: pictures of models under the light of real places.",
        "lambent"};
    Words words;
    RenderArguments render;
    ReferenceArguments reference;
    EnvArguments env;
    InfoArguments info;
    BakeGrammar bake;
    CompareGrammar compare;
    ReportGrammar report;
    ViewGrammar view;
    ServeGrammar serve;
    CLI::App* render_command = nullptr;
    CLI::App* reference_command = nullptr;
    CLI::App* env_command = nullptr;
    CLI::App* info_command = nullptr;

    Grammar()
    {
        app.set_version_flag("--version", text("lambent ", version));
        app.require_subcommand(1);
        app.footer("SCENE: a .gltf or .glb file, or sphere, teapot, plane, report, painted, grid, furnace.\n"
                   "'lambent COMMAND --help' lists a command's options.");
        add_render();
        bake.add(app);
        add_reference();
        compare.add(app);
        report.add(app);
        view.add(app);
        serve.add(app);
        add_env();
        add_info();
    }

    void add_render()
    {
        render_command = app.add_subcommand("render", "Draw a picture of a scene");
        add_picture(*render_command, render);
        option(*render_command, "--layers", render.layers, "DIR",
               "Also write each layer of the G-buffer and of the light");
    }

    void add_reference()
    {
        reference_command = app.add_subcommand("reference", "The same picture, path-traced");
        CLI::App& command = *reference_command;
        add_picture(command, reference.picture);
        option(command, "--bounces", words.bounces, "N",
               "Bounces of light; 0: direct light without shadows, 1: with shadows (8)");
        option(command, "--spp", words.spp, "N", "Stop at N samples per pixel (1024, if no limit is given)");
        option(command, "--noise", words.noise, "REL",
               "Stop at this estimated relative error (0.01, if no limit is given)");
        option(command, "--time", words.time, "S", "Stop after S seconds");
        option(command, "--seed", words.seed, "N", "Another number, other noise (0)");
        option(command, "--variance", reference.variance, "FILE",
               "Also write the variance of each value: .exr or .hdr");
        command.add_flag("--uniform", reference.uniform,
                         "As many samples for every pixel; so with --spp alone");
    }

    // What every command that makes a picture of a scene understands.
    void add_picture(CLI::App& command, RenderArguments& picture)
    {
        command.add_option("scene", picture.scene, "A .gltf or .glb, or a built-in scene")
            ->type_name("SCENE")
            ->required();
        add_output(command, picture.output,
                   "The picture: .png .jpg (as displayed), .exr .hdr (linear radiance)");
        add_light(command, picture, words);
        add_view(command, picture, words);
        add_material(command, words);
        add_display(command, picture, words);
        option(command, "--backend", words.backend, "NAME", "auto, cpu, or to draw vulkan (auto)");
        add_common(command, words);
    }

    void add_env()
    {
        env_command = app.add_subcommand("env", "Write a built-in environment");
        CLI::App& command = *env_command;
        command.add_option("name", env.name, "kitchen, studio, sky or furnace")
            ->type_name("NAME")
            ->required();
        add_output(command, env.output, "The panorama: .hdr or .exr");
        option(command, "--size", words.size, "WxH",
               "Size in texels, twice as wide as high (1024x512; kitchen 2048x1024)");
        option(command, "--sun", words.sun, "AZ,EL",
               "sky: where the sun stands, degrees, as --camera (-46,40)");
        option(command, "--turbidity", words.turbidity, "T", "sky: haze, 1.5 to 10 (2.2)");
        add_common(command, words);
    }

    void add_info()
    {
        info_command = app.add_subcommand("info", "Say what is in a glTF or an image");
        CLI::App& command = *info_command;
        command.add_option("file", info.file, "A .gltf, .glb, .hdr, .exr, .png or .jpg")
            ->type_name("FILE")
            ->required();
        command.add_flag("--json", info.json, "As one JSON object");
        add_common(command, words);
    }

    Arguments result()
    {
        if (render_command->parsed())
            return finished(words, render);
        if (reference_command->parsed())
            return finished(words, reference);
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
        if (env_command->parsed())
            return finished(words, env);
        info.common = common_options(words);
        return info;
    }
};

bool knows_command(const CLI::App& app, std::string_view name)
{
    const std::vector<const CLI::App*> commands = app.get_subcommands(nullptr);
    return std::any_of(commands.begin(), commands.end(),
                       [name](const CLI::App* command) { return command->check_name(std::string(name)); });
}

// The first line of a message, for CLI11's may be long.
std::string first_line(const std::string& message)
{
    return message.substr(0, message.find('\n'));
}

} // namespace

Arguments parse_arguments(int count, const char* const* words)
{
    if (count < 2)
        throw Error(Failure::usage, "no command given; lambent --help lists them");
    Grammar grammar;
    try {
        grammar.app.parse(count, words);
    } catch (const CLI::CallForHelp&) {
        return PrintText{grammar.app.help()};
    } catch (const CLI::CallForAllHelp&) {
        return PrintText{grammar.app.help("", CLI::AppFormatMode::All)};
    } catch (const CLI::CallForVersion&) {
        return PrintText{text("lambent ", version, "\n")};
    } catch (const CLI::ParseError& error) {
        if (count > 1 && words[1][0] != '-' && !knows_command(grammar.app, words[1]))
            throw Error(Failure::usage,
                        text("there is no command '", words[1], "'; lambent --help lists them"));
        throw Error(Failure::usage, first_line(error.what()));
    }
    return grammar.result();
}

} // namespace lambent::cli
