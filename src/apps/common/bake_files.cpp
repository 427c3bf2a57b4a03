#include "apps/common/bake_files.h"

#include "apps/common/new_folder.h"
#include "base/version.h"
#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "image/cube/cube_panorama.h"
#include "image/files/image_io.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <span>

namespace lambent::cli {
namespace {

using Json = nlohmann::ordered_json;
using Metadata = std::map<std::string, std::string>;

// The fewest digits that read back as the same float.
std::string exact(double number)
{
    char digits[64];
    const auto end = std::to_chars(digits, digits + sizeof digits, static_cast<float>(number)).ptr;
    return {digits, end};
}

std::string list(const std::vector<double>& numbers)
{
    std::string words;
    for (const double number : numbers)
        words += text(words.empty() ? "" : " ", exact(number));
    return words;
}

std::vector<double> roughness_of(const environment::BakedSpecular& specular)
{
    std::vector<double> roughness;
    for (const environment::BakedLevel& level : specular.levels)
        roughness.push_back(level.perceptual_roughness);
    return roughness;
}

// `specular`: with the roughness of the levels, which only the specular cube has.
Metadata metadata_of(const Baked& baked, const BakeArguments& arguments, bool specular)
{
    Metadata metadata = {{"KTXwriter", text("lambent ", version)}, {"lambent.sh", list(baked.coefficients)}};
    if (specular)
        metadata["lambent.roughness"] = list(roughness_of(baked.specular));
    if (arguments.mirrored)
        metadata["lambent.mirrored"] = "x";
    return metadata;
}

const char* extension(BakeFormat format)
{
    switch (format) {
    case BakeFormat::dds:
        return ".dds";
    case BakeFormat::exr:
        return ".exr";
    case BakeFormat::hdr:
        return ".hdr";
    case BakeFormat::ktx2:
        break;
    }
    return ".ktx2";
}

bool is_picture(BakeFormat format)
{
    return format == BakeFormat::exr || format == BakeFormat::hdr;
}

// Writes a cube map as KTX 2 or DDS.
void write_cube(const image::CubeMap& map, const BakeArguments& arguments, const Metadata& metadata,
                const std::filesystem::path& path)
{
    if (arguments.format == BakeFormat::ktx2)
        write_ktx2(map, {arguments.texels, arguments.zstd, metadata}, path);
    else
        write_dds(map, arguments.texels, path);
}

std::vector<std::string> write_one_file(const Baked& baked, const BakeArguments& arguments)
{
    const image::CubeMap& cube = baked.specular.cube;
    const Metadata metadata = metadata_of(baked, arguments, true);
    write_cube(arguments.mirrored ? mirrored(cube) : cube, arguments, metadata, arguments.output);
    return {arguments.output};
}

// Writes files into a folder and records their names.
class FolderWriter {
public:
    FolderWriter(const NewFolder& folder, const BakeArguments& arguments,
                 const std::function<void()>& before_file)
        : folder_(folder), arguments_(arguments), before_file_(before_file)
    {
    }

    /// Returns the names of each level's files; a KTX 2 or DDS file holds all levels and is named once.
    std::vector<std::vector<std::string>> cube(const image::CubeMap& map, const std::string& name,
                                               const Metadata& metadata)
    {
        const image::CubeMap turned = arguments_.mirrored ? mirrored(map) : image::CubeMap{};
        const image::CubeMap& written = arguments_.mirrored ? turned : map;
        if (!is_picture(arguments_.format)) {
            const std::string file = name + extension(arguments_.format);
            write_cube(written, arguments_, metadata, path(file));
            return {{file}};
        }
        std::vector<std::vector<std::string>> files;
        files.reserve(static_cast<std::size_t>(map.levels));
        for (int level = 0; level < map.levels; ++level)
            files.push_back(level_pictures(written, level, map.levels > 1 ? text(name, "_", level) : name));
        return files;
    }

    /// Writes a flat picture: .hdr if that is the format of the bake, else .exr.
    std::string picture(const image::RadianceImage& image, const std::string& name)
    {
        const BakeFormat format = arguments_.format == BakeFormat::hdr ? BakeFormat::hdr : BakeFormat::exr;
        std::string file = name + extension(format);
        image::write_radiance(image, path(file));
        return file;
    }

    std::string words(const std::string& content, const std::string& file)
    {
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(content.data());
        write_file(path(file), std::span(bytes, content.size()));
        return file;
    }

    const std::vector<std::string>& names() const { return names_; }

private:
    std::vector<std::string> level_pictures(const image::CubeMap& map, int level, const std::string& name)
    {
        if (arguments_.layout == CubeLayout::cross)
            return {picture(cross_image(map, level), name)};
        if (arguments_.layout == CubeLayout::equirectangular)
            return {picture(equirectangular_image(map, level, 2 * map.face_size(level)), name)};
        std::vector<std::string> files;
        files.reserve(image::face_names.size());
        for (int face = 0; face < 6; ++face)
            files.push_back(picture(face_image(map, level, face),
                                    text(name, "_", image::face_names[static_cast<std::size_t>(face)])));
        return files;
    }

    std::filesystem::path path(const std::string& name)
    {
        before_file_();
        names_.push_back(name);
        return folder_.path(name);
    }

    const NewFolder& folder_;
    const BakeArguments& arguments_;
    const std::function<void()>& before_file_;
    std::vector<std::string> names_;
};

// A line for each coefficient: red, green, blue.
std::string coefficient_lines(const std::vector<double>& coefficients)
{
    std::string lines;
    for (std::size_t i = 0; i < coefficients.size(); i += 3)
        lines += list({coefficients.begin() + static_cast<std::ptrdiff_t>(i),
                       coefficients.begin() + static_cast<std::ptrdiff_t>(i + 3)}) +
                 "\n";
    return lines;
}

const char* name_of(CubeLayout layout)
{
    return layout == CubeLayout::faces ? "faces" : layout == CubeLayout::cross ? "cross" : "equirectangular";
}

Json describe_input(const BakeArguments& arguments)
{
    Json json = {{"generator", text("lambent ", version)},
                 {"environment", arguments.environment},
                 {"env_rotation", arguments.rotation}};
    json["up"] = "+Y";
    json["layout"] = is_picture(arguments.format) ? name_of(arguments.layout) : "cube";
    json["faces"] = "+X -X +Y -Y +Z -Z";
    json["mirrored"] = arguments.mirrored;
    return json;
}

Json describe_specular(const Baked& baked, const BakeArguments& arguments,
                       const std::vector<std::vector<std::string>>& files)
{
    using environment::BakeLobe, environment::RoughnessMapping;
    const environment::BakeOptions& options = arguments.options;
    Json json = {{"lobe", options.lobe == BakeLobe::ggx ? "ggx" : "phong"},
                 {"roughness_mapping", options.mapping == RoughnessMapping::linear ? "linear" : "cmgen"},
                 {"error_aimed_at", options.error}};
    const bool one_file = files.size() == 1 && files.front().size() == 1;
    if (one_file)
        json["file"] = files.front().front();
    json["levels"] = describe_levels(baked.specular);
    for (std::size_t level = 0; !one_file && level < files.size(); ++level)
        json["levels"][level]["files"] = files[level];
    return json;
}

void write_all(const Baked& baked, const BakeArguments& arguments, FolderWriter& writer)
{
    Json json = describe_input(arguments);
    const auto specular = writer.cube(baked.specular.cube, "specular", metadata_of(baked, arguments, true));
    json["specular"] = describe_specular(baked, arguments, specular);
    json["irradiance"]["coefficients"] = {};
    for (const double c : baked.coefficients)
        json["irradiance"]["coefficients"].push_back(std::stod(exact(c)));
    json["irradiance"]["coefficients_file"] = writer.words(coefficient_lines(baked.coefficients), "sh.txt");
    if (baked.irradiance) {
        json["irradiance"]["size"] = baked.irradiance->size;
        json["irradiance"]["files"] =
            writer.cube(*baked.irradiance, "irradiance", metadata_of(baked, arguments, false)).front();
    }
    if (baked.table)
        json["split_sum"] = {{"size", baked.table->width},
                             {"file", writer.picture(*baked.table, "split_sum")}};
    // File names may hold any bytes; what is not UTF-8 is shown as a replacement character.
    writer.words(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n", "bake.json");
}

std::vector<std::string> write_folder(const Baked& baked, const BakeArguments& arguments,
                                      const std::function<void()>& before_file)
{
    NewFolder folder(arguments.output);
    FolderWriter writer(folder, arguments, before_file);
    try {
        write_all(baked, arguments, writer);
    } catch (const Error& error) {
        throw Error(error.failure(), folder.without_hiding(error.what()));
    }
    folder.put_in_place(writer.names(), InputFiles({arguments.environment}));
    return writer.names();
}

} // namespace

Json describe_levels(const environment::BakedSpecular& specular)
{
    Json levels = Json::array();
    for (std::size_t i = 0; i < specular.levels.size(); ++i)
        levels.push_back({{"size", specular.cube.face_size(static_cast<int>(i))},
                          {"roughness", specular.levels[i].perceptual_roughness},
                          // Rounded, because the sums of several threads differ in their last digits.
                          {"error", std::round(specular.levels[i].error * 1e6) / 1e6}});
    return levels;
}

CutLight cut_light(const Baked& baked, const BakeArguments& arguments)
{
    if (is_picture(arguments.format) || arguments.texels == image::TexelFormat::float4)
        return {};
    CutLight cut{0, arguments.texels == image::TexelFormat::half4 ? 65504.0 : 65408.0};
    const auto count = [&](const image::CubeMap& map) {
        for (std::size_t i = 0; i < map.values.size(); i += 3)
            if (std::max({map.values[i], map.values[i + 1], map.values[i + 2]}) >
                static_cast<float>(cut.most))
                ++cut.texels;
    };
    count(baked.specular.cube);
    if (baked.irradiance)
        count(*baked.irradiance);
    return cut;
}

void check_bake_output(const BakeArguments& arguments)
{
    if (arguments.one_file) {
        check_can_write(arguments.output);
        InputFiles({arguments.environment}).keep_from(arguments.output);
    } else {
        check_can_make_folder(arguments.output);
    }
}

std::vector<std::string> write_baked(const Baked& baked, const BakeArguments& arguments,
                                     const std::function<void()>& before_file)
{
    if (!arguments.one_file)
        return write_folder(baked, arguments, before_file);
    before_file();
    return write_one_file(baked, arguments);
}

} // namespace lambent::cli
