// The table of options: of `lambent bake`.
#include "apps/options/option_table.h"

namespace lambent::cli {
namespace {

Group<BakeArguments> bake_paths_group()
{
    using R = Row<BakeArguments>;
    return {"Options",
            command::bake,
            {R("env", "ENV", any_text("kitchen studio sky furnace"))
                 .at([](auto& a) -> auto& { return a.environment; })
                 .form(Form::positional)
                 .says("A panorama (.hdr, .exr), or kitchen, studio, sky, furnace"),
             R("output", "PATH", any_text())
                 .at([](auto& a) -> auto& { return a.output; })
                 .form(Form::required, 'o')
                 .says("A folder for everything, or the specular cube's FILE.ktx2 or .dds",
                       "`.ktx2` or `.dds`: one cube map of specular light; anything else: a folder for "
                       "everything, made if it is not there")}};
}

Group<BakeArguments> bake_light_group()
{
    using R = Row<BakeArguments>;
    return {
        "Light",
        command::bake,
        {R("size", "N", whole(1, 4096), "256")
             .at([](auto& a) -> auto& { return a.options.size; })
             .says("Texels along an edge of the specular cube, a power of two to 4096",
                   "texels along an edge of the specular cube: a power of two from 1 to 4096"),
         R("specular", "LOBE", one_of("ggx phong"), "ggx")
             .at([](auto& a) -> auto& { return a.options.lobe; })
             .says("ggx, or phong, as the report"),
         R("roughness", "MAP", one_of("linear cmgen"), "linear")
             .at([](auto& a) -> auto& { return a.options.mapping; })
             .says("Perceptual roughness of the levels: linear, or cmgen, as Filament's"),
         R("error", "REL", number(BakeArguments::least_error, BakeArguments::most_error), "0.01")
             .at([](auto& a) -> auto& { return a.options.error; })
             .says("Relative error aimed at in each level, 0.0005 to 0.2"),
         R("samples", "N", whole(1, 1 << 30))
             .at([](auto& a) -> auto& { return a.samples; })
             .says("Instead of --error: that of N samples, 0.32 / sqrt(N)"),
         R("irradiance", "sh|N", whole(1, 4096, "sh"))
             .at([](auto& a) -> auto& { return a.irradiance_size; })
             .usually("32")
             .says("Nine coefficients alone, or also a cube with N texels along an edge",
                   "`sh`: nine coefficients alone; N: also a cube with N texels along an edge, up to 4096"),
         R("lut", "N", whole(2, 1024))
             .at([](auto& a) -> auto& { return a.table_size; })
             .usually("128")
             .says("Texels along an edge of the split-sum table, 2 to 1024"),
         R("env-rotation", "DEG", any_number, "0")
             .at([](auto& a) -> auto& { return a.rotation; })
             .says("Turn the environment about the vertical",
                   "turns the environment about the vertical, by whole columns"),
         R("backend", "NAME", one_of("auto cpu vulkan"), "auto")
             .at([](auto& a) -> auto& { return a.backend; })
             .says("auto, cpu or vulkan", "as `render`; [bakes on a device](VULKAN.md#bakes)"),
         R("no-cache")
             .at([](auto& a) -> auto& { return a.cache; })
             .says("vulkan: neither read nor write compiled shaders",
                   "vulkan: compiled shaders are neither read nor written")}};
}

Group<BakeArguments> bake_files_group()
{
    using R = Row<BakeArguments>;
    return {"Files",
            command::bake,
            {R("format", "FORMAT", one_of("ktx2 dds exr hdr"), "ktx2")
                 .at([](auto& a) -> auto& { return a.format; })
                 .says("In a folder: ktx2, dds, exr or hdr",
                       "of a folder's files: `ktx2`, `dds`, or pictures: `exr`, `hdr`"),
             R("texels", "TYPE", one_of("half float rgb9e5"), "half")
                 .at([](auto& a) -> auto& { return a.texels; })
                 .says("ktx2, dds: half, float or rgb9e5"),
             R("layout", "LAYOUT", one_of("faces cross equirect"), "faces")
                 .at([](auto& a) -> auto& { return a.layout; })
                 .says("exr, hdr: faces, cross or equirect"),
             R("zstd")
                 .at([](auto& a) -> auto& { return a.zstd; })
                 .says("ktx2: compress the levels with Zstandard"),
             R("mirrored")
                 .at([](auto& a) -> auto& { return a.mirrored; })
                 .says("Turn x round, for three.js and others that look up (-x, y, z)",
                       "x turned round, for renderers that look up (-x, y, z)")}};
}

} // namespace

template <>
const std::vector<Group<BakeArguments>>& groups<BakeArguments>()
{
    static const std::vector<Group<BakeArguments>> all = {bake_paths_group(), bake_light_group(),
                                                          bake_files_group()};
    return all;
}

} // namespace lambent::cli
