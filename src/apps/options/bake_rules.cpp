#include "apps/options/rules.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <optional>

namespace lambent::cli {
namespace {

// The format of a single file, by its extension; nothing for a folder.
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

// The relative error of N random samples in light for which 1024 samples give 0.01.
double error_of_samples(int samples)
{
    return std::clamp(0.32 / std::sqrt(static_cast<double>(samples)), BakeArguments::least_error,
                      BakeArguments::most_error);
}

void settle_light(BakeArguments& arguments, const Given& given)
{
    environment::BakeOptions& options = arguments.options;
    if (!std::has_single_bit(static_cast<unsigned>(options.size)))
        throw Error(Failure::usage, text("--size: ", given.words("size").back(), " is not a power of two"));
    if (given("error") && arguments.samples)
        throw Error(Failure::usage, "--error and --samples exclude each other");
    if (arguments.samples)
        options.error = error_of_samples(*arguments.samples);
    arguments.rotation = std::remainder(arguments.rotation, 360.0);
}

void settle_format(BakeArguments& arguments, const Given& given)
{
    if (arguments.output.empty())
        throw Error(Failure::usage, "--output: the name is empty");
    const std::optional<BakeFormat> file = file_format(arguments.output);
    if (file && given("format") && *file != arguments.format)
        throw Error(Failure::usage, text("--format: ", given.words("format").back(), " is not the format of ",
                                         arguments.output));
    arguments.one_file = file.has_value();
    if (file)
        arguments.format = *file;
}

void check_texels(const BakeArguments& arguments, const Given& given)
{
    const bool is_picture = arguments.format == BakeFormat::exr || arguments.format == BakeFormat::hdr;
    if (given("layout") && !is_picture)
        throw Error(Failure::usage, "--layout: only with --format exr or hdr");
    if (arguments.mirrored && arguments.layout == CubeLayout::equirectangular)
        throw Error(Failure::usage,
                    "--mirrored: not with --layout equirect, which is the same for all renderers");
    if (given("texels") && is_picture)
        throw Error(Failure::usage, "--texels: only with --format ktx2 or dds");
    if (arguments.zstd && arguments.format != BakeFormat::ktx2)
        throw Error(Failure::usage, "--zstd: only with --format ktx2");
    if (arguments.zstd && !image::can_write_zstd())
        throw Error(Failure::usage, "--zstd: this program was built without libzstd");
}

} // namespace

void settle(BakeArguments& arguments, const Given& given)
{
    if (arguments.environment == "none")
        throw Error(Failure::usage, "none: there is no light to bake");
    settle_light(arguments, given);
    settle_format(arguments, given);
    check_texels(arguments, given);
}

} // namespace lambent::cli
