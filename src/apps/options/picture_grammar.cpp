#include "apps/options/picture_grammar.h"

#include "apps/options/values.h"
#include "scene/builtin/builtin.h"

#include <cmath>
#include <utility>

namespace lambent::cli {
namespace {

void add_view(Command app, RenderArguments& arguments, PictureWords& words)
{
    option(app, "--size", words.size, "WxH", "Picture size in pixels (1280x720)");
    option(app, "--camera", words.camera, "AZ,EL[,DIST]",
           "Degrees around and above the scene, metres from its middle (frames it)");
    option(app, "--target", words.target, "X,Y,Z",
           "The point that --camera, with a distance, is around, metres (the scene's middle)");
    option(app, "--camera-node", arguments.camera_node, "NAME",
           "A camera of the glTF, with its own field of view");
    option(app, "--fov", words.fov, "DEG", "Vertical field of view, 0.1 to 175 (45)");
    option(app, "--aa", words.aa, "N", "Samples per pixel where surfaces end (4)");
    option(app, "--animation", words.animation, "NAME|N",
           "An animation of the glTF, or its number from 0 (none; with --moment 0)");
    option(app, "--moment", words.moment, "S", "Seconds from its start, at most its duration (0)");
}

void add_light(Command app, RenderArguments& arguments, PictureWords& words)
{
    option(app, "--env", arguments.environment, "ENV",
           "A panorama (.hdr, .exr), or kitchen, studio, sky, furnace, none (kitchen)");
    option(app, "--env-rotation", words.rotation, "DEG", "Turn the environment about the vertical (0)");
    option(app, "--background", words.background, "KIND", "env, none, R,G,B or blur:ROUGHNESS (env)");
    app.add_repeated("--light", words.lights, "LIGHT",
                     "directional:AZ,EL,R,G,B (lux) or point:X,Y,Z,R,G,B (candela); repeatable");
    option(app, "--ambient-brightness", words.ambient, "B",
           "Factor on diffuse environment light (1; the report's is 2)");
    option(app, "--ibl", words.ibl, "METHOD",
           "Specular environment light: sampled, or split-sum, 8 samples (sampled)");
    option(app, "--samples", words.samples, "N", "Samples of the specular lobe (40)");
    app.add_flag("--no-cache", words.no_cache, "Neither read nor write the environment cache");
}

void add_material(Command app, PictureWords& words)
{
    option(app, "--model", words.model, "MODEL", "ggx, as glTF, or phong, as the report (ggx)");
    option(app, "--roughness", words.roughness, "R",
           "ggx: perceptual roughness of all surfaces, 0 to 1, instead of their own");
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

void add_display(Command app, RenderArguments& arguments, PictureWords& words)
{
    option(app, "--exposure", words.exposure, "E", "Factor on the light before the tone curve (1)");
    option(app, "--contrast", words.contrast, "K", "Power on the curve's result (1)");
    option(app, "--tone", words.tone, "CURVE", "reinhard, neutral, aces, agx or linear (reinhard)");
    option(app, "--space", words.space, "SPACE",
           "linear, or nonlinear: neither texels nor output converted (linear)");
    app.add_flag("--dither", arguments.display.dither, "Noise of one code against banding");
}

void apply_view(const PictureWords& words, RenderArguments& arguments)
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
    if (!words.fov.empty() && !arguments.camera_node.empty())
        throw Error(Failure::usage, "--fov and --camera-node exclude each other: a camera has its own");
    if (!words.fov.empty())
        arguments.vertical_fov = radians(number_in(words.fov, "--fov", 0.1, 175.0));
    if (!words.aa.empty())
        arguments.settings.edge_samples = whole_in(words.aa, "--aa", 1, 64);
}

void apply_moment(const PictureWords& words, RenderArguments& arguments)
{
    for (const auto& [name, word] : {std::pair("--animation", &words.animation), {"--moment", &words.moment}})
        if (!word->empty() && scene::is_builtin(arguments.scene))
            throw Error(Failure::usage, text(name, ": only with a .gltf or .glb"));
    arguments.animation = words.animation;
    if (words.moment.empty())
        return;
    arguments.moment = parse_number(words.moment, "--moment");
    if (*arguments.moment < 0.0)
        throw Error(Failure::usage, text("--moment: '", words.moment, "' is before the start"));
}

void apply_light(const PictureWords& words, RenderArguments& arguments)
{
    draw::Settings& settings = arguments.settings;
    if (!words.rotation.empty())
        settings.environment_rotation =
            radians(std::remainder(parse_number(words.rotation, "--env-rotation"), 360.0));
    if (!words.background.empty())
        settings.background = parse_background(words.background, "--background");
    for (const std::string& light : words.lights) {
        settings.lights.push_back(parse_light(light, "--light"));
        arguments.light_places.push_back(light_place(light, "--light"));
    }
    if (!words.ambient.empty())
        settings.ambient_brightness = number_in(words.ambient, "--ambient-brightness", 0.0, 1.0e6);
    if (!words.samples.empty())
        settings.samples = whole_in(words.samples, "--samples", 1, 65536);
    if (!words.ibl.empty() && choose<bool>(words.ibl, "--ibl", {{"sampled", false}, {"split-sum", true}}))
        settings.samples = draw::split_sum_samples;
}

void apply_roughness(const std::string& word, draw::Settings& settings)
{
    if (word.empty())
        return;
    if (settings.model != draw::Model::ggx)
        throw Error(Failure::usage, "--roughness: only with --model ggx; phong's is --alpha, the exponent");
    settings.roughness_override = number_in(word, "--roughness", 0.0, 1.0);
}

void apply_material(const PictureWords& words, RenderArguments& arguments)
{
    using draw::Model, draw::MipLevel;
    draw::Settings& settings = arguments.settings;
    if (!words.model.empty())
        settings.model =
            choose<Model>(words.model, "--model", {{"ggx", Model::ggx}, {"phong", Model::phong}});
    apply_roughness(words.roughness, settings);
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

void apply_display(const PictureWords& words, RenderArguments& arguments)
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
    settings.unlit_by_power = arguments.settings.texel_transfer == TexelTransfer::power_2_2;
}

} // namespace

std::vector<std::pair<std::string, std::string>> PictureWords::given() const
{
    std::vector<std::pair<std::string, std::string>> all = {{"size", size},
                                                            {"camera", camera},
                                                            {"target", target},
                                                            {"fov", fov},
                                                            {"aa", aa},
                                                            {"animation", animation},
                                                            {"moment", moment},
                                                            {"env-rotation", rotation},
                                                            {"background", background},
                                                            {"ambient-brightness", ambient},
                                                            {"ibl", ibl},
                                                            {"samples", samples},
                                                            {"model", model},
                                                            {"roughness", roughness},
                                                            {"mip-level", mip_level},
                                                            {"alpha", alpha},
                                                            {"kd", kd},
                                                            {"ks", ks},
                                                            {"density", density},
                                                            {"exposure", exposure},
                                                            {"contrast", contrast},
                                                            {"tone", tone},
                                                            {"space", space},
                                                            {"backend", backend}};
    std::erase_if(all, [](const auto& option) { return option.second.empty(); });
    return all;
}

void PictureGrammar::add(Command& command)
{
    command.add_required("scene", arguments_.scene, "SCENE", "A .gltf or .glb, or a built-in scene");
    add_light(command.under("Light"), arguments_, words_);
    add_view(command.under("View and moment"), arguments_, words_);
    add_material(command.under("Materials and built-in shapes"), words_);
    add_display(command.under("From light to pixels"), arguments_, words_);
    Command same = command.under(everywhere);
    option(same, "--backend", words_.backend, "NAME", "auto, cpu, or to draw vulkan (auto)");
    add_common(command, words_);
}

RenderArguments PictureGrammar::result() const
{
    RenderArguments arguments = arguments_;
    arguments.common = common_options(words_);
    arguments.cache = !words_.no_cache;
    apply_view(words_, arguments);
    apply_moment(words_, arguments);
    apply_light(words_, arguments);
    apply_material(words_, arguments);
    apply_display(words_, arguments);
    if (!words_.backend.empty())
        arguments.backend = choose_backend(words_.backend);
    return arguments;
}

void PictureGrammar::use_report_pipeline(RenderArguments& arguments) const
{
    draw::Settings& settings = arguments.settings;
    display::Settings& display = arguments.display;
    if (settings.model != draw::Model::phong)
        throw Error(Failure::usage, "--pipeline report: only with --model phong");
    if (!words_.mip_level.empty() && settings.mip_level != draw::MipLevel::report)
        throw Error(Failure::usage,
                    "--pipeline report: its levels are the report's, not --mip-level matched");
    if (display.tone != display::Tone::reinhard)
        throw Error(Failure::usage, "--pipeline report: its tone curve is the report's: no --tone");
    settings.pipeline = draw::ReportPipeline{display.exposure, display.contrast, display.encode};
    settings.mip_level = draw::MipLevel::report;
    settings.texel_transfer = draw::TexelTransfer::none; // its passes decode
    if (words_.ambient.empty())
        settings.ambient_brightness = 2.0f;
    // What is drawn are codes.
    display.exposure = display.contrast = 1.0f;
    display.tone = display::Tone::linear;
    display.encode = false;
}

StartArguments PictureGrammar::start() const
{
    StartArguments start{result(), words_.given(), words_.lights};
    if (start.picture.common.stats_json)
        throw Error(Failure::usage, "--stats: not with viewers, which run until they are ended");
    return start;
}

} // namespace lambent::cli
