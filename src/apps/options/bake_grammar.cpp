#include "apps/options/bake_grammar.h"

#include "apps/options/values.h"
#include "environment/builtin/builtin.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <optional>

namespace lambent::cli {
namespace {

constexpr double least_error = 0.0005, most_error = 0.2;

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
    for (const char* other : {".exr", ".hdr", ".png", ".jpg", ".jpeg", ".ktx"})
        if (extension == other)
            throw Error(Failure::usage,
                        text(output, ": one file is a .ktx2 or .dds; -o FOLDER --format exr or hdr writes "
                                     "pictures"));
    return std::nullopt;
}

bool is_picture(BakeFormat format)
{
    return format == BakeFormat::exr || format == BakeFormat::hdr;
}

// What the noise of N samples a texel would be worth where light is as uneven as 1024 samples are for 0.01.
double error_of_samples(int samples)
{
    return std::clamp(0.32 / std::sqrt(static_cast<double>(samples)), least_error, most_error);
}

} // namespace

void BakeGrammar::add(Command& app)
{
    command_ = app.add_subcommand("bake", "Prefilter an environment for other renderers");
    command_.add_required("env", arguments_.environment, "ENV",
                          "A panorama (.hdr, .exr), or kitchen, studio, sky, furnace");
    command_.add_required("-o,--output", arguments_.output, "PATH",
                          "A folder for everything, or the specular cube's FILE.ktx2 or .dds");
    add_light(command_.under("Light"));
    add_files(command_.under("Files"));
    add_common(command_, common_);
}

void BakeGrammar::add_light(Command command)
{
    option(command, "--size", size_, "N",
           "Texels along an edge of the specular cube, a power of two to 4096 (256)");
    option(command, "--specular", specular_, "LOBE", "ggx, or phong, as the report (ggx)");
    option(command, "--roughness", roughness_, "MAP",
           "Perceptual roughness of the levels: linear, or cmgen, as Filament's (linear)");
    option(command, "--error", error_, "REL", "Relative error aimed at in each level, 0.0005 to 0.2 (0.01)");
    option(command, "--samples", samples_, "N", "Instead of --error: that of N samples, 0.32 / sqrt(N)");
    option(command, "--irradiance", irradiance_, "sh|N",
           "Nine coefficients alone, or also a cube with N texels along an edge (32)");
    option(command, "--lut", table_, "N", "Texels along an edge of the split-sum table, 2 to 1024 (128)");
    option(command, "--env-rotation", rotation_, "DEG", "Turn the environment about the vertical (0)");
    option(command, "--backend", backend_, "NAME", "auto, cpu or vulkan (auto)");
    command.add_flag("--no-cache", no_cache_, "vulkan: neither read nor write compiled shaders");
}

void BakeGrammar::add_files(Command command)
{
    option(command, "--format", format_, "FORMAT", "In a folder: ktx2, dds, exr or hdr (ktx2)");
    option(command, "--texels", texels_, "TYPE", "ktx2, dds: half, float or rgb9e5 (half)");
    option(command, "--layout", layout_, "LAYOUT", "exr, hdr: faces, cross or equirect (faces)");
    command.add_flag("--zstd", arguments_.zstd, "ktx2: compress the levels with Zstandard");
    command.add_flag("--mirrored", arguments_.mirrored,
                     "Turn x round, for three.js and others that look up (-x, y, z)");
}

void BakeGrammar::apply_light(BakeArguments& arguments) const
{
    using environment::BakeLobe, environment::RoughnessMapping;
    environment::BakeOptions& options = arguments.options;
    if (!size_.empty())
        options.size = whole_in(size_, "--size", 1, 4096);
    if (!std::has_single_bit(static_cast<unsigned>(options.size)))
        throw Error(Failure::usage, text("--size: ", size_, " is not a power of two"));
    if (!specular_.empty())
        options.lobe =
            choose<BakeLobe>(specular_, "--specular", {{"ggx", BakeLobe::ggx}, {"phong", BakeLobe::phong}});
    if (!roughness_.empty())
        options.mapping = choose<RoughnessMapping>(
            roughness_, "--roughness",
            {{"linear", RoughnessMapping::linear}, {"cmgen", RoughnessMapping::cmgen}});
    apply_error(options);
    if (!irradiance_.empty())
        arguments.irradiance_size = irradiance_ == "sh" ? 0 : whole_in(irradiance_, "--irradiance", 1, 4096);
    if (!table_.empty())
        arguments.table_size = whole_in(table_, "--lut", 2, 1024);
    if (!backend_.empty())
        arguments.backend = choose_backend(backend_);
    arguments.cache = !no_cache_;
    if (!rotation_.empty())
        arguments.rotation = std::remainder(parse_number(rotation_, "--env-rotation"), 360.0);
}

void BakeGrammar::apply_error(environment::BakeOptions& options) const
{
    if (!error_.empty() && !samples_.empty())
        throw Error(Failure::usage, "--error and --samples exclude each other");
    if (!samples_.empty())
        options.error = error_of_samples(whole_in(samples_, "--samples", 1, 1 << 30));
    if (error_.empty())
        return;
    number_in(error_, "--error", least_error, most_error);
    options.error = parse_number(error_, "--error"); // in double: as a float 0.2 would be above itself
}

void BakeGrammar::apply_files(BakeArguments& arguments) const
{
    if (arguments.output.empty())
        throw Error(Failure::usage, "--output: nothing given");
    const std::optional<BakeFormat> file = file_format(arguments.output);
    if (!format_.empty())
        arguments.format = choose<BakeFormat>(format_, "--format",
                                              {{"ktx2", BakeFormat::ktx2},
                                               {"dds", BakeFormat::dds},
                                               {"exr", BakeFormat::exr},
                                               {"hdr", BakeFormat::hdr}});
    if (file && !format_.empty() && *file != arguments.format)
        throw Error(Failure::usage, text("--format: ", format_, " is not what ", arguments.output, " says"));
    arguments.one_file = file.has_value();
    if (file)
        arguments.format = *file;
    apply_pictures(arguments);
    apply_texels(arguments);
}

void BakeGrammar::apply_pictures(BakeArguments& arguments) const
{
    if (layout_.empty())
        return;
    if (!is_picture(arguments.format))
        throw Error(Failure::usage, "--layout: only with --format exr or hdr");
    arguments.layout = choose<CubeLayout>(layout_, "--layout",
                                          {{"faces", CubeLayout::faces},
                                           {"cross", CubeLayout::cross},
                                           {"equirect", CubeLayout::equirectangular}});
    if (arguments.mirrored && arguments.layout == CubeLayout::equirectangular)
        throw Error(Failure::usage,
                    "--mirrored: not with --layout equirect, which looks the same to everyone");
}

void BakeGrammar::apply_texels(BakeArguments& arguments) const
{
    using image::TexelFormat;
    if (!texels_.empty() && is_picture(arguments.format))
        throw Error(Failure::usage, "--texels: only with --format ktx2 or dds");
    if (!texels_.empty())
        arguments.texels = choose<TexelFormat>(
            texels_, "--texels",
            {{"half", TexelFormat::half4}, {"float", TexelFormat::float4}, {"rgb9e5", TexelFormat::rgb9e5}});
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
    apply_light(arguments);
    apply_files(arguments);
    return arguments;
}

} // namespace lambent::cli
