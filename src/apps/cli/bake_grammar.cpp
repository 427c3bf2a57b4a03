#include "apps/cli/bake_grammar.h"

#include "apps/cli/values.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

namespace lambent::cli {
namespace {

// The format that a name asks for: of one file, else it is a folder.
std::optional<BakeFormat> file_format(const std::string& output)
{
    std::string extension = std::filesystem::path(output).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".ktx2")
        return BakeFormat::ktx2;
    if (extension == ".dds")
        return BakeFormat::dds;
    for (const char* picture : {".exr", ".hdr", ".png", ".jpg", ".ktx"})
        if (extension == picture)
            throw Error(
                Failure::usage,
                text(output,
                     ": one file is a .ktx2 or a .dds; -o FOLDER --format exr or hdr writes pictures"));
    return std::nullopt;
}

// N samples a texel are worth about this: their noise, where the environment is as hard as most.
double error_of_samples(int samples)
{
    return std::clamp(0.32 / std::sqrt(static_cast<double>(samples)), 0.0005, 0.2);
}

} // namespace

void BakeGrammar::add(CLI::App& app)
{
    command_ = app.add_subcommand("bake",
                                  "Prefilter an environment for a renderer: irradiance, specular, split sum");
    CLI::App& command = *command_;
    command
        .add_option("env", arguments_.environment,
                    "A panorama (.hdr, .exr), or kitchen, studio, sky, furnace")
        ->type_name("ENV")
        ->required();
    command
        .add_option("-o,--output", arguments_.output,
                    "A folder for everything, or FILE.ktx2 or .dds for the specular cube")
        ->type_name("PATH")
        ->required();
    option(command, "--size", size_, "N",
           "Specular: texels along an edge of the cube, a power of two to 4096 (256)");
    option(command, "--irradiance", irradiance_, "sh|N",
           "Irradiance: nine coefficients alone, or a cube of N texels too (32)");
    option(command, "--specular", specular_, "LOBE", "ggx, or phong, as the report (ggx)");
    option(command, "--error", error_, "REL",
           "Relative error to stay below in each level, 0.0005 to 0.2 (0.01)");
    option(command, "--samples", samples_, "N", "Instead: the error of N samples, 0.32 / sqrt(N)");
    option(command, "--roughness", roughness_, "MAP",
           "Roughness of the levels: linear, or cmgen, as Filament's (linear)");
    option(command, "--lut", table_, "N", "Split-sum table: texels along an edge, 2 to 1024 (128)");
    option(command, "--format", format_, "FORMAT", "In a folder: ktx2, dds, exr or hdr (ktx2)");
    option(command, "--texels", texels_, "TYPE", "ktx2, dds: half, float or rgb9e5 (half)");
    option(command, "--layout", layout_, "LAYOUT", "exr, hdr: faces, cross or equirect (faces)");
    command.add_flag("--zstd", arguments_.zstd, "ktx2: compress the levels with Zstandard");
    command.add_flag("--mirrored", arguments_.mirrored,
                     "Turn x round, for three.js and others whose cubes are left-handed");
    command.add_flag("--no-cache", no_cache_, "No effect: a bake never uses the cache");
    add_common(command, common_);
}

void BakeGrammar::apply_work(BakeArguments& arguments) const
{
    environment::BakeOptions& options = arguments.options;
    if (!size_.empty())
        options.size = whole_in(size_, "--size", 1, 4096);
    if ((options.size & (options.size - 1)) != 0)
        throw Error(Failure::usage, text("--size: ", size_, " is not a power of two"));
    if (!specular_.empty())
        options.lobe = choose<environment::BakeLobe>(
            specular_, "--specular",
            {{"ggx", environment::BakeLobe::ggx}, {"phong", environment::BakeLobe::phong}});
    if (!roughness_.empty())
        options.mapping =
            choose<environment::RoughnessMapping>(roughness_, "--roughness",
                                                  {{"linear", environment::RoughnessMapping::linear},
                                                   {"cmgen", environment::RoughnessMapping::cmgen}});
    if (!error_.empty() && !samples_.empty())
        throw Error(Failure::usage, "--error and --samples exclude each other");
    if (!error_.empty())
        options.error = static_cast<double>(number_in(error_, "--error", 0.0005, 0.2));
    if (!samples_.empty())
        options.error = error_of_samples(whole_in(samples_, "--samples", 1, 1 << 24));
    if (irradiance_ == "sh")
        arguments.irradiance_size = 0;
    else if (!irradiance_.empty())
        arguments.irradiance_size = whole_in(irradiance_, "--irradiance", 1, 4096);
    if (!table_.empty())
        arguments.table_size = whole_in(table_, "--lut", 2, 1024);
}

void BakeGrammar::apply_files(BakeArguments& arguments) const
{
    const std::optional<BakeFormat> file = file_format(arguments.output);
    if (!format_.empty())
        arguments.format = choose<BakeFormat>(format_, "--format",
                                              {{"ktx2", BakeFormat::ktx2},
                                               {"dds", BakeFormat::dds},
                                               {"exr", BakeFormat::exr},
                                               {"hdr", BakeFormat::hdr}});
    if (file && !format_.empty() && *file != arguments.format)
        throw Error(Failure::usage, text("--format ", format_, ": ", arguments.output, " says another"));
    arguments.one_file = file.has_value();
    if (file)
        arguments.format = *file;
    const bool pictures = arguments.format == BakeFormat::exr || arguments.format == BakeFormat::hdr;
    if (!layout_.empty() && !pictures)
        throw Error(Failure::usage, "--layout: only with --format exr or hdr");
    if (!layout_.empty())
        arguments.layout = choose<CubeLayout>(layout_, "--layout",
                                              {{"faces", CubeLayout::faces},
                                               {"cross", CubeLayout::cross},
                                               {"equirect", CubeLayout::equirectangular}});
    if (!texels_.empty() && pictures)
        throw Error(Failure::usage, "--texels: only with --format ktx2 or dds");
    if (!texels_.empty())
        arguments.texels = choose<image::TexelFormat>(texels_, "--texels",
                                                      {{"half", image::TexelFormat::half4},
                                                       {"float", image::TexelFormat::float4},
                                                       {"rgb9e5", image::TexelFormat::rgb9e5}});
    if (arguments.zstd && arguments.format != BakeFormat::ktx2)
        throw Error(Failure::usage, "--zstd: only with --format ktx2");
    if (arguments.zstd && !image::can_write_zstd())
        throw Error(Failure::usage, "--zstd: this program was built without libzstd");
}

BakeArguments BakeGrammar::result() const
{
    BakeArguments arguments = arguments_;
    arguments.common = common_options(common_);
    if (arguments.environment == "none")
        throw Error(Failure::usage, "none: there is no light to bake");
    apply_work(arguments);
    apply_files(arguments);
    return arguments;
}

} // namespace lambent::cli
