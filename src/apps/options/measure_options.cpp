// The table of options: of `lambent reference`, `compare` and `report`.
#include "apps/options/option_table.h"

namespace lambent::cli {

template <>
const std::vector<Group<ReferenceArguments>>& groups<ReferenceArguments>()
{
    using R = Row<ReferenceArguments>;
    static const std::vector<Group<ReferenceArguments>> all = {
        {"Tracing",
         command::reference,
         {R("spp", "N", whole(1, 1 << 20))
              .at([](auto& a) -> auto& { return a.samples; })
              .usually("1024, if no limit is given")
              .says("Stop at N samples per pixel", "stop at N samples per pixel, on average"),
          R("noise", "REL", number(1e-6, 1.0))
              .at([](auto& a) -> auto& { return a.noise; })
              .usually("0.01, if no limit is given")
              .says("Stop at this estimated relative error of what surfaces cover",
                    "stop at this estimated relative error of what surfaces cover "
                    "([whose](REFERENCE.md#noise))"),
          R("time", "S", above_zero())
              .at([](auto& a) -> auto& { return a.seconds; })
              .says("Stop after S seconds"),
          R("seed", "N", whole(0, 1 << 30), "0")
              .at([](auto& a) -> auto& { return a.seed; })
              .says("Another number, other noise"),
          R("variance", "FILE", any_text())
              .at([](auto& a) -> auto& { return a.variance; })
              .says("Also write the variance of each value: .exr or .hdr",
                    "also write the variance of each value, not cut: `.exr` or `.hdr`; makes two samples at "
                    "least"),
          R("uniform")
              .at([](auto& a) -> auto& { return a.uniform; })
              .says("As many samples for every pixel; so with --spp alone")}}};
    return all;
}

template <>
const std::vector<Group<CompareArguments>>& groups<CompareArguments>()
{
    using R = Row<CompareArguments>;
    static const std::vector<Group<CompareArguments>> all = {
        {"Options",
         command::compare,
         {R("image", "IMAGE", any_text())
              .at([](auto& a) -> auto& { return a.picture; })
              .form(Form::positional)
              .says("A .png, .jpg, .exr or .hdr"),
          R("reference", "REFERENCE", any_text())
              .at([](auto& a) -> auto& { return a.reference; })
              .form(Form::positional)
              .says("What it should be: of the same size and kind"),
          R("output", "FILE", any_text())
              .at([](auto& a) -> auto& { return a.output; })
              .form(Form::option, 'o')
              .says("A map of the error with a legend: .png or .jpg",
                    "the error at each pixel in colours, with their numbers: `.png` or `.jpg`"),
          R("heat", "ERROR", one_of("flip relative absolute"), "flip")
              .at([](auto& a) -> auto& { return a.heat; })
              .says("What it shows: flip, relative or absolute",
                    "which: `flip`; `relative`, to the reference at the pixel and a hundredth of its mean, "
                    "up to 1; `absolute`"),
          R("exposure", "E", above_zero())
              .at([](auto& a) -> auto& { return a.exposure; })
              .usually("1")
              .says("Factor on both, linear light only",
                    "factor on both, linear light only; HDR-FLIP, which exposes for itself, only notices "
                    "what `--clamp` then cuts"),
          R("clamp", "X", above_zero())
              .at([](auto& a) -> auto& { return a.clamp; })
              .says("Cut both to [0, X], after the exposure"),
          R("ppd", "P", number(1.0, 1000.0), "67")
              .at([](auto& a) -> auto& { return a.pixels_per_degree; })
              .says("FLIP: pixels in a degree of the view, 1 to 1000",
                    "FLIP: pixels in a degree of the field of view, 1 to 1000; a 3840 pixels wide screen "
                    "from its width away has 67"),
          R("max-flip", "X", not_negative)
              .at([](auto& a) -> auto& { return a.max_flip; })
              .says("Exit with 1 if the mean FLIP error is above X", "exit code 1 if `flip` is above X"),
          R("max-rel", "X", not_negative)
              .at([](auto& a) -> auto& { return a.max_relative; })
              .says("Exit with 1 if the relative RMSE is above X",
                    "exit code 1 if `relative_rmse` is above X"),
          R("json")
              .at([](auto& a) -> auto& { return a.json; })
              .says("One JSON object, on a terminal too", "the JSON object on a terminal too")}}};
    return all;
}

template <>
const std::vector<Group<ReportArguments>>& groups<ReportArguments>()
{
    using R = Row<ReportArguments>;
    static const std::vector<Group<ReportArguments>> all = {
        {"Options",
         command::report,
         {R("output", "DIR", any_text())
              .at([](auto& a) -> auto& { return a.output; })
              .form(Form::required, 'o')
              .says("The folder: index.html, report.json and pictures"),
          R("env", "ENV", any_text("kitchen studio sky furnace"), "kitchen")
              .at([](auto& a) -> auto& { return a.environment; })
              .says("A panorama (.hdr, .exr), or kitchen, studio, sky, furnace",
                    "the light of the figures; not `none`"),
          R("env-rotation", "DEG", any_number, "0")
              .at([](auto& a) -> auto& { return a.rotation; })
              .says("Turn the environment about the vertical"),
          R("size", "WxH", {Domain::Kind::size}, "512x288")
              .at([](auto& a) -> auto& { return a; })
              .says("Size of a figure in pixels", "of a figure, 16x16 to 4096x4096"),
          R("quick").at([](auto& a) -> auto& { return a.quick; }).says("No references, no errors"),
          R("noise", "REL", number(1e-4, 1.0), "0.02")
              .at([](auto& a) -> auto& { return a.noise; })
              .says("References stop at this estimated relative error",
                    "references stop at this estimated relative error of what surfaces cover"),
          R("spp", "N", whole(1, 1 << 20), "48")
              .at([](auto& a) -> auto& { return a.samples; })
              .says("References stop at N samples per pixel", "or at N samples per pixel"),
          R("no-cache")
              .at([](auto& a) -> auto& { return a.cache; })
              .says("Neither read nor write the environment cache",
                    "neither read nor write the [environment cache](ENVIRONMENTS.md#the-cache)"),
          R("backend", "NAME", one_of("auto cpu"), "auto")
              .at([](auto& a) -> auto& { return a.backend; })
              .says("auto or cpu", "`auto` or `cpu`")}}};
    return all;
}

} // namespace lambent::cli
