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
              .says("Stop at this estimated relative error of the pixels that surfaces cover",
                    "stop at this estimated relative error of the pixels that surfaces cover "
                    "([definition](REFERENCE.md#noise))"),
          R("time", "S", above_zero())
              .at([](auto& a) -> auto& { return a.seconds; })
              .says("Stop after S seconds"),
          R("seed", "N", whole(0, 1 << 30), "0")
              .at([](auto& a) -> auto& { return a.seed; })
              .says("Seed of the noise"),
          R("variance", "FILE", any_text())
              .at([](auto& a) -> auto& { return a.variance; })
              .says(
                  "Also write the variance of each value: .exr or .hdr",
                  "also write the variance of each value, of light that is not cut: `.exr` or `.hdr`; takes "
                  "at least two samples per pixel"),
          R("uniform")
              .at([](auto& a) -> auto& { return a.uniform; })
              .says("The same number of samples for every pixel, as with --spp alone"),
          R("denoise")
              .at([](auto& a) -> auto& { return a.denoise; })
              .says("Filter the noise out of the picture",
                    "filter the noise out of the picture ([how](FILTER.md#the-filter-of-pictures)) and "
                    "measure the "
                    "[error](AUDIT.md) that is left"),
          R("no-audit")
              .at([](auto& a) -> auto& { return a.audit; })
              .says("Do not measure the error of --denoise",
                    "do not measure the error of a picture with `--denoise`")}}};
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
              .says("The picture: .png, .jpg, .exr or .hdr"),
          R("reference", "REFERENCE", any_text())
              .at([](auto& a) -> auto& { return a.reference; })
              .form(Form::positional)
              .says("The picture to compare it with, of the same size and kind"),
          R("output", "FILE", any_text())
              .at([](auto& a) -> auto& { return a.output; })
              .form(Form::option, 'o')
              .says("Heat map of the error, with a legend: .png or .jpg",
                    "heat map of the error at each pixel, with a legend: `.png` or `.jpg`"),
          R("heat", "ERROR", one_of("flip relative absolute"), "flip")
              .at([](auto& a) -> auto& { return a.heat; })
              .says("Error in the heat map: flip, relative or absolute",
                    "error in the heat map: `flip`; `relative`, to the reference at the pixel plus a "
                    "hundredth of its mean, up to 1; `absolute`"),
          R("exposure", "E", above_zero())
              .at([](auto& a) -> auto& { return a.exposure; })
              .usually("1")
              .says("Factor on both pictures, linear light only",
                    "factor on both pictures, linear light only; HDR-FLIP chooses its own exposures, so this "
                    "matters to it only through `--clamp`"),
          R("clamp", "X", above_zero())
              .at([](auto& a) -> auto& { return a.clamp; })
              .says("Clamp both pictures to [0, X], after the exposure"),
          R("covered")
              .at([](auto& a) -> auto& { return a.covered; })
              .says("Compare only pixels that surfaces cover: .exr with alpha",
                    "compare only the pixels that surfaces cover, in part at least, in either picture: "
                    "`.exr` files "
                    "with alpha; this is the measure of [the error tables](ERRORS.md)"),
          R("ppd", "P", number(1.0, 1000.0), "67")
              .at([](auto& a) -> auto& { return a.pixels_per_degree; })
              .says("FLIP: pixels per degree of the field of view, 1 to 1000",
                    "FLIP: pixels per degree of the field of view, 1 to 1000; 67 is a screen 3840 pixels "
                    "wide, seen from as far away as it is wide"),
          R("max-flip", "X", not_negative)
              .at([](auto& a) -> auto& { return a.max_flip; })
              .says("Exit with 1 if the mean FLIP error is above X", "exit code 1 if `flip` is above X"),
          R("max-rel", "X", not_negative)
              .at([](auto& a) -> auto& { return a.max_relative; })
              .says("Exit with 1 if the relative RMSE is above X",
                    "exit code 1 if `relative_rmse` is above X"),
          R("json")
              .at([](auto& a) -> auto& { return a.json; })
              .says("Print the JSON object on a terminal too")}}};
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
              .says("Folder for index.html, report.json and the pictures"),
          R("env", "ENV", any_text("kitchen studio sky furnace"), "kitchen")
              .at([](auto& a) -> auto& { return a.environment; })
              .says("A panorama (.hdr, .exr), or kitchen, studio, sky, furnace",
                    "environment of the figures; not `none`"),
          R("env-rotation", "DEG", any_number, "0")
              .at([](auto& a) -> auto& { return a.rotation; })
              .says("Rotation of the environment about the vertical axis"),
          R("size", "WxH", {Domain::Kind::size}, "512x288")
              .at([](auto& a) -> auto& { return a; })
              .says("Size of a figure in pixels", "size of a figure in pixels, 16x16 to 4096x4096"),
          R("quick")
              .at([](auto& a) -> auto& { return a.quick; })
              .says("Leave out the references and the errors"),
          R("noise", "REL", number(1e-4, 1.0), "0.02")
              .at([](auto& a) -> auto& { return a.noise; })
              .says("References stop at this estimated relative error",
                    "references stop at this estimated relative error of the pixels that surfaces cover"),
          R("spp", "N", whole(1, 1 << 20), "48")
              .at([](auto& a) -> auto& { return a.samples; })
              .says("References stop at N samples per pixel"),
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
