#include "apps/cli/bake_files.h"

#include "apps/cli/version.h"
#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "image/cube_panorama.h"
#include "image/image_io.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <span>
#include <system_error>

namespace lambent::cli {
namespace {

namespace fs = std::filesystem;

// The fewest digits that give the number back.
template <class Number>
std::string exact(Number number)
{
    char digits[64];
    return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
}

std::string list(const std::vector<double>& numbers)
{
    std::string words;
    for (const double number : numbers) {
        if (!words.empty())
            words += ' ';
        words += exact(static_cast<float>(number));
    }
    return words;
}

std::vector<double> roughness_of(const environment::BakedSpecular& specular)
{
    std::vector<double> roughness;
    for (const environment::BakedLevel& level : specular.levels)
        roughness.push_back(level.perceptual_roughness);
    return roughness;
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
    default:
        return ".ktx2";
    }
}

// Writes files and remembers their names.
class Writer {
public:
    Writer(const BakeArguments& arguments, fs::path folder)
        : arguments_(arguments), folder_(std::move(folder))
    {
    }

    void cube(const image::CubeMap& map, const std::string& name,
              const std::map<std::string, std::string>& metadata)
    {
        const image::CubeMap turned = arguments_.mirrored ? mirrored(map) : map;
        if (arguments_.format == BakeFormat::ktx2)
            write_ktx2(turned, {arguments_.texels, arguments_.zstd, metadata}, path(name + ".ktx2"));
        else if (arguments_.format == BakeFormat::dds)
            write_dds(turned, arguments_.texels, path(name + ".dds"));
        else
            for (int level = 0; level < turned.levels; ++level)
                pictures(turned, level, turned.levels > 1 ? text(name, "_", level) : name);
    }

    void picture(const image::RadianceImage& image, const std::string& name)
    {
        const BakeFormat format = arguments_.format == BakeFormat::hdr ? BakeFormat::hdr : BakeFormat::exr;
        image::write_radiance(image, path(name + extension(format)));
    }

    void json(const nlohmann::ordered_json& object, const std::string& name)
    {
        const std::string content = object.dump(2) + "\n";
        write_file(path(name),
                   std::span(reinterpret_cast<const std::uint8_t*>(content.data()), content.size()));
    }

    std::vector<std::string> names;

private:
    void pictures(const image::CubeMap& map, int level, const std::string& name)
    {
        if (arguments_.layout == CubeLayout::cross)
            picture(cross_image(map, level), name);
        else if (arguments_.layout == CubeLayout::equirectangular)
            picture(equirectangular_image(map, level, 2 * map.face_size(level)), name);
        else
            for (int face = 0; face < 6; ++face)
                picture(face_image(map, level, face),
                        text(name, "_", image::face_names[static_cast<std::size_t>(face)]));
    }

    fs::path path(const std::string& name)
    {
        names.push_back(name);
        return folder_ / name;
    }

    const BakeArguments& arguments_;
    fs::path folder_;
};

std::map<std::string, std::string> specular_metadata(const Baked& baked)
{
    return {{"KTXwriter", text("lambent ", version)},
            {"lambent.roughness", list(roughness_of(baked.specular))},
            {"lambent.sh", list(baked.coefficients)}};
}

nlohmann::ordered_json describe(const Baked& baked, const BakeArguments& arguments,
                                const std::vector<std::string>& names)
{
    nlohmann::ordered_json levels = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < baked.specular.levels.size(); ++i) {
        const environment::BakedLevel& level = baked.specular.levels[i];
        levels.push_back({{"size", baked.specular.cube.face_size(static_cast<int>(i))},
                          {"roughness", level.perceptual_roughness},
                          {"error", level.error}});
    }
    return {{"generator", text("lambent ", version)},
            {"environment", arguments.environment},
            {"lobe", arguments.options.lobe == environment::BakeLobe::ggx ? "ggx" : "phong"},
            {"mirrored", arguments.mirrored},
            {"levels", levels},
            {"irradiance_sh", baked.coefficients},
            {"files", names}};
}

} // namespace

void check_bake_output(const BakeArguments& arguments)
{
    if (arguments.one_file) {
        check_can_write(arguments.output);
        return;
    }
    std::error_code error;
    fs::create_directories(arguments.output, error);
    if (error)
        throw Error(Failure::cannot_write,
                    text(arguments.output, ": cannot make the folder: ", error.message()));
    check_can_write(fs::path(arguments.output) / "bake.json");
}

std::vector<std::string> write_baked(const Baked& baked, const BakeArguments& arguments)
{
    if (arguments.one_file) {
        const fs::path path = arguments.output;
        const image::CubeMap turned = arguments.mirrored ? mirrored(baked.specular.cube) : image::CubeMap{};
        const image::CubeMap& cube = arguments.mirrored ? turned : baked.specular.cube;
        if (arguments.format == BakeFormat::ktx2)
            write_ktx2(cube, {arguments.texels, arguments.zstd, specular_metadata(baked)}, path);
        else
            write_dds(cube, arguments.texels, path);
        return {arguments.output};
    }
    Writer writer(arguments, arguments.output);
    writer.cube(baked.specular.cube, "specular", specular_metadata(baked));
    if (baked.irradiance)
        writer.cube(*baked.irradiance, "irradiance",
                    {{"KTXwriter", text("lambent ", version)}, {"lambent.sh", list(baked.coefficients)}});
    if (baked.table)
        writer.picture(*baked.table, "split_sum");
    writer.json(describe(baked, arguments, writer.names), "bake.json");
    return writer.names;
}

} // namespace lambent::cli
