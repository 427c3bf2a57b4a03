// The table of options: scene, light, camera, animation and output of a picture.
#include "apps/options/look_options.h"
#include "apps/options/option_table.h"

#include "base/error.h"
#include "base/text.h"
#include "scene/builtin/builtin.h"

#include <utility>

namespace lambent::cli {
namespace {

using A = RenderArguments;
using Kind = Domain::Kind;
constexpr std::string_view environments = "kitchen studio sky furnace none";

void add_light(A& arguments, const Option& option, const std::string& word)
{
    arguments.settings.lights.push_back(parse_light(word, dashed(option)));
    arguments.light_places.push_back(light_place(word, dashed(option)));
    arguments.light_words.push_back(word);
}

std::string light_words(const A& arguments, const Option&)
{
    std::string words;
    for (const std::string& word : arguments.light_words)
        words += text(words.empty() ? "" : " ", word);
    return words;
}

void set_moment(A& arguments, const Option& option, const std::string& word)
{
    arguments.moment.reset();
    if (word.empty())
        return;
    const double moment = number_of(option, word);
    if (moment < 0.0)
        throw Error(Failure::usage, text(dashed(option), ": '", word, "' is before the animation's start"));
    arguments.moment = moment;
}

std::string moment_word(const A& arguments, const Option& option)
{
    return word_of(option, arguments.moment);
}

const char* wanted(Needs needs)
{
    switch (needs) {
    case Needs::ggx:
        return "--model ggx; for --model phong, --alpha sets the exponent";
    case Needs::phong_shapes:
        return "--model phong and a built-in shape";
    case Needs::shapes:
        return "a built-in shape";
    default:
        return "a .gltf or .glb";
    }
}

Group<A> light_group()
{
    using R = Row<A>;
    return {"Light",
            command::of_scenes,
            {R("env", "ENV", any_text(environments), "kitchen")
                 .at([](auto& a) -> auto& { return a.environment; })
                 .says("Environment: a panorama (.hdr, .exr), or kitchen, studio, sky, furnace, none"),
             R("env-rotation", "DEG", {Kind::angle}, "0")
                 .at([](auto& a) -> auto& { return a.settings.environment_rotation; })
                 .says("Rotation of the environment about the vertical axis")
                 .control(7, {"Rotation", "Light", -180.0, 180.0}),
             R("background", "KIND", {Kind::background, 0, 0, false, "env none blur:"}, "env")
                 .at([](auto& a) -> auto& { return a.settings.background; })
                 .says("Background: env, none, R,G,B or blur:ROUGHNESS",
                       "background: `env`, `none` (transparent), `R,G,B` (radiance) or `blur:ROUGHNESS`")
                 .control(11, {"Background", "Light", 0, 0, false,
                               "env none blur:0.2 blur:0.4 blur:0.7 0,0,0 0.2,0.2,0.2 1,1,1"}),
             R("light", "LIGHT", {Kind::light, 0, 0, false, "directional: point:"})
                 .at({add_light, light_words})
                 .form(Form::repeated)
                 .says("directional:AZ,EL,R,G,B (lux) or point:X,Y,Z,R,G,B (candela); repeatable",
                       "`directional:AZ,EL,R,G,B` in lux, from azimuth and elevation as for `--camera`, or "
                       "`point:X,Y,Z,R,G,B` in candela; repeatable")
                 .place(20),
             R("ambient-brightness", "B", number(0.0, 1.0e6), "1")
                 .at([](auto& a) -> auto& { return a.settings.ambient_brightness; })
                 .usually("1; in the 2014 report 2")
                 .says("Factor on diffuse environment light")
                 .control(8, {"Diffuse brightness", "Light", 0.0, 20.0}),
             R("ibl", "METHOD", one_of("sampled split-sum"), "sampled")
                 .at([](auto& a) -> auto& { return a.split_sum; })
                 .says("Specular environment light: sampled, or split-sum, 8 samples",
                       "specular environment light: `sampled`, or `split-sum`: [8 wide "
                       "lookups](ERRORS.md#split-sum), whatever `--samples` is")
                 .control(9, {"Specular light", "Light"}),
             // The control ends below the limit of the option: more samples take minutes.
             R("samples", "N", whole(1, 65536), "40")
                 .at([](auto& a) -> auto& { return a.settings.samples; })
                 .says("Samples of the specular lobe")
                 .control(10, {"Samples", "Light", 1.0, 1024.0, true}),
             R("no-cache")
                 .at([](auto& a) -> auto& { return a.cache; })
                 .says("Neither read nor write the environment cache",
                       "neither read nor write the [environment cache](ENVIRONMENTS.md#the-cache)")}};
}

Group<A> view_group()
{
    using R = Row<A>;
    return {
        "View and time",
        command::of_scenes,
        {R("size", "WxH", {Kind::size}, "1280x720")
             .at([](auto& a) -> auto& { return a.settings; })
             .says("Picture size in pixels"),
         R("camera", "AZ,EL[,DIST]", {Kind::orbit})
             .at([](auto& a) -> auto& { return a.orbit; })
             .usually("frames the scene")
             .says("Azimuth and elevation in degrees, distance from the target in metres",
                   "azimuth and elevation in degrees, distance from the target in metres; at azimuth 0 the "
                   "camera looks from +Z"),
         R("target", "X,Y,Z", {Kind::place})
             .at([](auto& a) -> auto& { return a.target; })
             .usually("the scene's centre")
             .says("Point around which --camera is placed, in metres; needs its distance"),
         R("camera-node", "NAME", any_text())
             .at([](auto& a) -> auto& { return a.camera_node; })
             .says("A camera of the glTF, with its own field of view",
                   "[a camera of the glTF](#cameras-and-places): its node's name, else its own, else "
                   "`camera0`, `camera1`, ..."),
         R("fov", "DEG", {Kind::angle, 0.1, 175.0}, "45")
             .at([](auto& a) -> auto& { return a.vertical_fov; })
             .says("Vertical field of view, 0.1 to 175 degrees",
                   "vertical field of view, 0.1 to 175 degrees; not with `--camera-node`")
             .control(18, {"Field of view", "Camera", 1.0, 170.0}),
         R("aa", "N", whole(1, 64), "24")
             .at([](auto& a) -> auto& { return a.settings.edge_samples; })
             .says("Samples per pixel at the edges of surfaces")
             .control(19, {"Edge samples", "Camera", 1.0, 64.0}),
         R("animation", "NAME|N", any_text())
             .at([](auto& a) -> auto& { return a.animation; })
             .form(Form::joined)
             .usually("none, or 0 with --moment")
             .says("An animation of the glTF, by name or by number from 0",
                   "an animation of the glTF, by its name (`info` lists them), else by its number from "
                   "0; without one, the scene is as it is in the file")
             .only(Needs::file)
             .place(22),
         R("moment", "S", any_number)
             .at({set_moment, moment_word})
             .form(Form::joined)
             .usually("0")
             .says("Time in seconds from the animation's start, at most its duration",
                   "time in seconds from the animation's start; later times show its end; the camera "
                   "frames the scene as it is in the file, so that the view is the same at all times")
             .only(Needs::file)
             .place(23)}};
}

Group<A> scene_group()
{
    using R = Row<A>;
    return {"Options",
            command::of_scenes,
            {R("scene", "SCENE", any_text("sphere teapot plane report painted grid furnace"))
                 .at([](auto& a) -> auto& { return a.scene; })
                 .form(Form::positional)
                 .says("A .gltf or .glb, or a built-in scene")}};
}

Group<A> output_group()
{
    using R = Row<A>;
    return {"Options",
            command::render | command::reference,
            {R("output", "FILE", any_text())
                 .at([](auto& a) -> auto& { return a.output; })
                 .form(Form::required, 'o')
                 .says("Picture: .png .jpg (as displayed), .exr .hdr (linear radiance)",
                       "`.png` or `.jpg`: as displayed; `.exr` or `.hdr`: linear radiance before exposure "
                       "and tone curve, in `.exr` with coverage as alpha")}};
}

Group<A> render_group()
{
    using R = Row<A>;
    return {
        "Options",
        command::render,
        {R("layers", "DIR", any_text())
             .at([](auto& a) -> auto& { return a.layers; })
             .says("Also write each layer of the G-buffer and of the light",
                   "also write each layer of the G-buffer and of the light, as `.exr` with its values and "
                   "as `.png` to look at ([list](#layers))"),
         R("passes", "N", whole(1, 4096), "2")
             .at([](auto& a) -> auto& { return a.settings.passes; })
             .says("Rounds of rays; only with --bounces above 0",
                   "rounds of rays: two samples of every pixel in the first, in each later one about as much "
                   "work where the picture is not yet known well; only with `--bounces` above 0")
             .place(27),
         R("error", "REL", number(1e-4, 1.0))
             .at([](auto& a) -> auto& { return a.error; })
             .says("Add rounds of rays until the measured error is at most REL",
                   "add rounds of rays until [the measured error](AUDIT.md) is at most REL; only with "
                   "`--bounces` above 0"),
         R("time", "S", above_zero())
             .at([](auto& a) -> auto& { return a.seconds; })
             .says("Add rounds of rays for S seconds of drawing",
                   "add rounds of rays for S seconds of drawing, one at least; reading files and the last "
                   "measurement of the error are not counted; only with `--bounces` above 0"),
         R("no-audit")
             .at([](auto& a) -> auto& { return a.audit; })
             .says("Do not measure the picture's error", "do not measure the picture's error. A picture with "
                                                         "`--bounces` above 0 is measured [against "
                                                         "its reference](AUDIT.md)"),
         R("audit")
             .at([](auto& a) -> auto& { return a.audit_always; })
             .says("Measure the picture's error also with --bounces 0"),
         R("pipeline", "ORDER", one_of("light report"), "light")
             .at([](auto& a) -> auto& { return a.report_pipeline; })
             .says("light: sum the light, then display it; report: as in the 2014 report",
                   "`light`: the light is summed, then displayed; `report`: [the 2014 report's own "
                   "pipeline](REPORT.md#the-reports-own-pipeline), only with `--model phong`")}};
}

} // namespace

template <>
const std::vector<Group<A>>& groups<A>()
{
    static const std::vector<Group<A>> all = {
        scene_group(),  light_group(),  view_group(),   material_group(), display_group(),
        device_group(), output_group(), render_group(), bounces_group(),  viewer_group()};
    return all;
}

bool applies(Needs needs, const RenderArguments& arguments)
{
    const bool phong = arguments.settings.model == draw::Model::phong;
    switch (needs) {
    case Needs::ggx:
        return !phong;
    case Needs::phong_shapes:
        return phong && scene::is_builtin(arguments.scene);
    case Needs::shapes:
        return scene::is_builtin(arguments.scene);
    case Needs::file:
        return !scene::is_builtin(arguments.scene);
    default:
        return true;
    }
}

void check_needs(const Option& option, const RenderArguments& arguments)
{
    if (!applies(option.needs, arguments))
        throw Error(Failure::usage, text(dashed(option), ": only with ", wanted(option.needs)));
}

} // namespace lambent::cli
