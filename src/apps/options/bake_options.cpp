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
                 .says("Folder for all files, or FILE.ktx2 or .dds for the specular cube alone",
                       "`.ktx2` or `.dds`: one cube map of specular light; anything else: a folder for all "
                       "files, created if it does not exist")}};
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
             .says("Lobe: ggx, or phong as in the 2014 report"),
         R("roughness", "MAP", one_of("linear cmgen"), "linear")
             .at([](auto& a) -> auto& { return a.options.mapping; })
             .says("Perceptual roughness by level: linear, or cmgen as in Filament"),
         R("error", "REL", number(BakeArguments::least_error, BakeArguments::most_error), "0.01")
             .at([](auto& a) -> auto& { return a.options.error; })
             .says("Target for the relative error of each level, 0.0005 to 0.2"),
         R("samples", "N", whole(1, 1 << 30))
             .at([](auto& a) -> auto& { return a.samples; })
             .says("Target as the error of N samples, 0.32 / sqrt(N); not with --error"),
         R("irradiance", "sh|N", whole(1, 4096, "sh"))
             .at([](auto& a) -> auto& { return a.irradiance_size; })
             .usually("32")
             .says("sh: nine coefficients only; N: also a cube with N texels along an edge",
                   "`sh`: nine coefficients only; N: also a cube with N texels along an edge, up to 4096"),
         R("lut", "N", whole(2, 1024))
             .at([](auto& a) -> auto& { return a.table_size; })
             .usually("128")
             .says("Texels along an edge of the split-sum table, 2 to 1024"),
         R("env-rotation", "DEG", any_number, "0")
             .at([](auto& a) -> auto& { return a.rotation; })
             .says("Rotation of the environment about the vertical axis",
                   "rotation of the environment about the vertical axis, rounded to whole columns"),
         R("backend", "NAME", one_of("auto cpu vulkan"), "auto")
             .at([](auto& a) -> auto& { return a.backend; })
             .says("auto, cpu or vulkan", "as for `render`; [baking on a device](VULKAN.md#bakes)"),
         R("no-cache")
             .at([](auto& a) -> auto& { return a.cache; })
             .says("vulkan: neither read nor write the cache of compiled shaders")}};
}

Group<BakeArguments> bake_files_group()
{
    using R = Row<BakeArguments>;
    return {"Files",
            command::bake,
            {R("format", "FORMAT", one_of("ktx2 dds exr hdr"), "ktx2")
                 .at([](auto& a) -> auto& { return a.format; })
                 .says("Format of a folder's files: ktx2, dds, exr or hdr",
                       "format of a folder's files: `ktx2` or `dds`, or as pictures `exr` or `hdr`"),
             R("texels", "TYPE", one_of("half float rgb9e5"), "half")
                 .at([](auto& a) -> auto& { return a.texels; })
                 .says("ktx2, dds: texel type half, float or rgb9e5"),
             R("layout", "LAYOUT", one_of("faces cross equirect"), "faces")
                 .at([](auto& a) -> auto& { return a.layout; })
                 .says("exr, hdr: layout faces, cross or equirect"),
             R("zstd")
                 .at([](auto& a) -> auto& { return a.zstd; })
                 .says("ktx2: compress the levels with Zstandard"),
             R("mirrored")
                 .at([](auto& a) -> auto& { return a.mirrored; })
                 .says("Mirror x, for three.js and others that look up (-x, y, z)",
                       "mirror x, for renderers that look up (-x, y, z)")}};
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
