// The table of options: materials, display, backend, and what viewers set.
#include "apps/options/look_options.h"

namespace lambent::cli {

Group<RenderArguments> material_group()
{
    using R = Row<RenderArguments>;
    using Kind = Domain::Kind;
    return {
        "Materials and built-in shapes",
        command::of_scenes,
        {R("model", "MODEL", one_of("ggx phong"), "ggx")
             .at([](auto& a) -> auto& { return a.settings.model; })
             .says("Shading model: ggx as in glTF, or phong as in the 2014 report",
                   "shading model: `ggx` as in glTF, or `phong` [as in the 2014 report](PHONG.md)")
             .control(12, {"Shading model", "Surfaces"}),
         R("roughness", "R", number(0.0, 1.0))
             .at([](auto& a) -> auto& { return a.settings.roughness_override; })
             .says("ggx: perceptual roughness of all surfaces, 0 to 1, instead of their own",
                   "ggx: perceptual roughness of all surfaces, 0 to 1, instead of their materials' and "
                   "textures'")
             .only(Needs::ggx)
             .control(13, {"Roughness", "Surfaces", 0.0, 1.0}),
         R("mip-level", "RULE", one_of("matched report"), "matched")
             .at([](auto& a) -> auto& { return a.settings.mip_level; })
             .says("phong: matched to the lobe, or the report's own choice, which shows blocks",
                   "phong: `matched` to the lobe, or the `report`'s own sample points and levels, which show "
                   "blocks")
             .control(14, {"Mip level", "Surfaces"}),
         R("alpha", "A", above_zero(1.0e6))
             .at([](auto& a) -> auto& { return a.builtin.exponent; })
             .says("phong, built-in shapes: exponent, above 0, at most 1e6")
             .only(Needs::phong_shapes)
             .control(15, {"Exponent", "Surfaces", 0.01, 1.0e6, true}),
         R("kd", "R,G,B", {Kind::color})
             .at([](auto& a) -> auto& { return a.builtin.diffuse; })
             .says("phong, built-in shapes: diffuse colour")
             .only(Needs::phong_shapes)
             .control(16, {"Diffuse colour", "Surfaces", 0.0, 1.0}),
         R("ks", "R,G,B", {Kind::color})
             .at([](auto& a) -> auto& { return a.builtin.specular; })
             .says("phong, built-in shapes: specular colour")
             .only(Needs::phong_shapes)
             .control(17, {"Specular colour", "Surfaces", 0.0, 1.0}),
         R("density", "X", number(0.0625, 8.0), "1")
             .at([](auto& a) -> auto& { return a.builtin.density; })
             .says("Built-in shapes: factor on the number of triangles along an edge")
             .only(Needs::shapes)
             .place(21),
         R("no-energy-compensation")
             .at([](auto& a) -> auto& { return a.settings.energy_compensation; })
             .says("ggx: leave out light scattered more than once")
             .place(25)}};
}

Group<RenderArguments> display_group()
{
    using R = Row<RenderArguments>;
    return {
        "From light to pixels",
        command::of_scenes,
        {// The slider covers the exposures of all of the report's pictures.
         R("exposure", "E", above_zero(), "1")
             .at([](auto& a) -> auto& { return a.display.exposure; })
             .says("Factor on the light before the tone curve")
             .control(1, {"Exposure", "Display", 1e-3, 1e4, true}),
         R("contrast", "K", above_zero(), "1")
             .at([](auto& a) -> auto& { return a.display.contrast; })
             .says("Exponent on the tone curve's result")
             .control(2, {"Contrast", "Display", 0.05, 20.0, true}),
         R("tone", "CURVE", one_of("reinhard neutral aces agx linear"), "reinhard")
             .at([](auto& a) -> auto& { return a.display.tone; })
             .says("Tone curve: reinhard, neutral, aces, agx or linear",
                   "tone curve: `reinhard` (the report's), `neutral` (Khronos), `aces`, `agx` or `linear`")
             .control(3, {"Tone curve", "Display"}),
         R("space", "SPACE", one_of("linear nonlinear"), "linear")
             .at([](auto& a) -> auto& { return a.display.encode; })
             .says("Colour space of shading: linear, or nonlinear, which converts neither texels nor "
                   "the result")
             .control(4, {"Space", "Display"}),
         R("dither")
             .at([](auto& a) -> auto& { return a.display.dither; })
             .says("Add noise of one code value against banding")
             .place(26)}};
}

Group<RenderArguments> device_group()
{
    using R = Row<RenderArguments>;
    return {"Everywhere",
            command::of_scenes,
            {R("backend", "NAME", one_of("auto cpu vulkan"), "auto")
                 .at([](auto& a) -> auto& { return a.backend; })
                 .says("auto, cpu or, for drawing only, vulkan",
                       "`cpu`; `vulkan`: [a Vulkan device](VULKAN.md), hardware before software; `auto`: a "
                       "hardware device if there is one, else the CPU")
                 .place(24)}};
}

Group<RenderArguments> viewer_group()
{
    using R = Row<RenderArguments>;
    return {
        "Viewers",
        command::viewers_alone,
        {R("layer", "LAYER",
           one_of(
               "picture reference error base_color specular alpha roughness metalness normal depth occlusion "
               "mip_level irradiance light_emitted light_direct light_ambient light_specular background"),
           "picture")
             .at([](auto& a) -> auto& { return a.shown; })
             .says("Image to show: the picture, its reference, the error, or a layer")
             .control(5, {"Show", "Display"})}};
}

Group<RenderArguments> bounces_group()
{
    using R = Row<RenderArguments>;
    return {
        "Light",
        command::of_scenes,
        {R("bounces", "N", whole(0, 1024), "8")
             .at([](auto& a) -> auto& { return a.bounces; })
             .says("Bounces of light; 0: direct light without shadows, 1: with shadows",
                   "bounces of light. 0: direct light without shadows, what image based lighting "
                   "approximates; 1: with shadows; more: from surface to surface ([how](LIGHT.md)). Pictures "
                   "of the 2014 report, `--pipeline report`, `--mip-level report` or "
                   "`--ambient-brightness`, are drawn with 0")
             .control(6, {"Bounces", "Light", 0.0, 64.0})}};
}

} // namespace lambent::cli
