// Implements the public interface: converts internal types to public ones, and Error to BakeError.
#include "lambent/bake.h"

#include "base/error.h"
#include "base/text.h"
#include "environment/bake/bake.h"
#include "environment/bake/split_sum.h"
#include "environment/builtin/builtin.h"
#include "environment/bake/irradiance.h"
#include "environment/panorama/panorama.h"
#include "image/cube/cube_files.h"
#include "image/cube/cube_map.h"
#include "image/files/image_io.h"
#include "image/refuse.h"

#include <algorithm>

namespace lambent {

struct Panorama::Texels {
    environment::Panorama panorama;
    Warnings warnings;
};

struct PanoramaAccess {
    using Texels = Panorama::Texels;

    static Panorama make(Texels texels)
    {
        return Panorama(std::make_shared<const Texels>(std::move(texels)));
    }

    static const environment::Panorama& of(const Panorama& panorama) { return panorama.texels_->panorama; }
};

namespace {

BakeError::Kind kind_of(Failure failure)
{
    switch (failure) {
    case Failure::usage:
        return BakeError::Kind::bad_argument;
    case Failure::cannot_write:
        return BakeError::Kind::cannot_write;
    default:
        return BakeError::Kind::bad_input;
    }
}

// Runs `work` and rethrows its Error as a BakeError.
template <class Work>
auto translated(const Work& work)
{
    try {
        return work();
    } catch (const Error& error) {
        throw BakeError(kind_of(error.failure()), error.what());
    }
}

template <class... Parts>
void require(bool condition, const std::string& possible, const Parts&... what)
{
    if (!condition)
        throw BakeError(BakeError::Kind::bad_argument, text(what..., ": ", possible));
}

// Reads rows of floats in memory as if they came from a file, so that they are corrected in the same way.
class MemoryReader : public image::RadianceReader {
public:
    MemoryReader(int width, int height, std::span<const float> rgb) : left_(rgb)
    {
        width_ = width;
        height_ = height;
    }

    void read_rows(int count, float* rgb) override
    {
        const std::size_t floats = 3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(count);
        std::copy_n(left_.begin(), floats, rgb);
        left_ = left_.subspan(floats);
    }

private:
    std::span<const float> left_;
};

CubeMap to_public(image::CubeMap&& cube)
{
    return {cube.size, cube.levels, std::move(cube.values)};
}

image::CubeMap to_internal(const CubeMap& cube)
{
    return {cube.size, cube.levels, cube.values};
}

image::TexelFormat to_internal(TexelFormat format)
{
    switch (format) {
    case TexelFormat::float4:
        return image::TexelFormat::float4;
    case TexelFormat::rgb9e5:
        return image::TexelFormat::rgb9e5;
    default:
        return image::TexelFormat::half4;
    }
}

environment::BakeOptions to_internal(const SpecularOptions& options)
{
    using environment::BakeLobe;
    using Mapping = environment::RoughnessMapping;
    return {.size = options.size,
            .lobe = options.lobe == Lobe::phong ? BakeLobe::phong : BakeLobe::ggx,
            .mapping = options.mapping == RoughnessMapping::cmgen ? Mapping::cmgen : Mapping::linear,
            .error = options.error};
}

} // namespace

Panorama Panorama::load(const std::filesystem::path& path)
{
    return translated([&] {
        Texels texels;
        texels.panorama = environment::load_panorama(path, texels.warnings);
        return PanoramaAccess::make(std::move(texels));
    });
}

Panorama Panorama::from_pixels(int width, int height, std::span<const float> rgb)
{
    const std::string possible = text("the size must be 2x1 to ", image::max_side, "x", image::max_side,
                                      " and at most ", image::max_pixels, " texels");
    require(width >= 2 && width <= image::max_side && height >= 1 && height <= image::max_side &&
                std::int64_t{width} * height <= image::max_pixels,
            possible, "a panorama of ", width, "x", height);
    const std::size_t floats = 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    require(rgb.size() == floats, text(floats, " are needed"), rgb.size(), " floats for a panorama of ",
            width, "x", height);
    return translated([&] {
        Texels texels;
        MemoryReader reader(width, height, rgb);
        texels.panorama = environment::load_panorama(reader, "panorama", texels.warnings);
        return PanoramaAccess::make(std::move(texels));
    });
}

Panorama Panorama::builtin(std::string_view name, const BuiltinOptions& options)
{
    return translated([&] {
        const image::RadianceImage image = environment::make_builtin(
            name, {options.width, options.sun_azimuth, options.sun_elevation, options.turbidity});
        return PanoramaAccess::make({environment::make_panorama(image), {}});
    });
}

int Panorama::width() const
{
    return texels_->panorama.width;
}

int Panorama::height() const
{
    return texels_->panorama.height;
}

std::array<float, 3> Panorama::radiance(int x, int y) const
{
    require(x >= 0 && x < width() && y >= 0 && y < height(), text("the panorama is ", width(), "x", height()),
            "texel ", x, ",", y, " of a panorama");
    const environment::Rgb c = texels_->panorama.radiance(x, y);
    return {c.r, c.g, c.b};
}

const std::vector<std::string>& Panorama::warnings() const
{
    return texels_->warnings;
}

Specular bake_specular(const Panorama& panorama, const SpecularOptions& options,
                       const std::function<void(double)>& progress)
{
    return translated([&] {
        environment::BakedSpecular baked =
            environment::bake_specular(PanoramaAccess::of(panorama), to_internal(options), progress);
        Specular specular{to_public(std::move(baked.cube)), {}};
        for (const environment::BakedLevel& level : baked.levels)
            specular.levels.push_back({level.perceptual_roughness, level.error});
        return specular;
    });
}

CubeMap bake_irradiance(const Panorama& panorama, int size)
{
    return translated(
        [&] { return to_public(environment::bake_irradiance(PanoramaAccess::of(panorama), size)); });
}

Harmonics bake_irradiance_harmonics(const Panorama& panorama)
{
    return translated([&] {
        const std::vector<double> flat = environment::irradiance_coefficients(
            environment::project_to_harmonics(PanoramaAccess::of(panorama)));
        Harmonics harmonics;
        for (std::size_t i = 0; i < harmonics.size(); ++i)
            harmonics[i] = {flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]};
        return harmonics;
    });
}

SplitSumTable bake_split_sum_table(int size)
{
    return translated([&] {
        image::RadianceImage table = environment::bake_split_sum_table(size);
        return SplitSumTable{size, std::move(table.values)};
    });
}

bool can_write_zstd()
{
    return image::can_write_zstd();
}

void write_ktx2(const CubeMap& cube, const std::filesystem::path& path, const Ktx2Options& options)
{
    translated([&] {
        image::write_ktx2(to_internal(cube), {to_internal(options.format), options.zstd, options.metadata},
                          path);
    });
}

void write_dds(const CubeMap& cube, const std::filesystem::path& path, TexelFormat format)
{
    translated([&] { image::write_dds(to_internal(cube), to_internal(format), path); });
}

} // namespace lambent
