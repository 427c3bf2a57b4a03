#include "environment/bake/bake.h"

#include "base/text.h"
#include "environment/bake/bake_check.h"
#include "environment/chain/make_chain.h"
#include "environment/panorama/resized.h"
#include "equations/in_double.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace lambent::environment {
namespace {

constexpr int most_rounds = 3;
constexpr double usual_fineness = 0.7; // for an error of 0.01
constexpr double irradiance_fineness = 5.0, irradiance_extent = 0.02;

double roughness_of(const BakeOptions& options, int level, int levels)
{
    const double t = levels > 1 ? static_cast<double>(level) / (levels - 1) : 0.0;
    return options.mapping == RoughnessMapping::cmgen ? 1.0 - std::sqrt(1.0 - t) : t;
}

PrefilterLobe lobe_of(const BakeOptions& options, double roughness)
{
    const double alpha = std::max(roughness * roughness, 1e-4);
    return options.lobe == BakeLobe::ggx ? ggx_lobe(alpha) : phong_lobe(in_double::phong_exponent(alpha));
}

// Fills level 0 with the panorama, not blurred: each texel is the mean of bilinear lookups over its area.
void fill_sharp(const Panorama& panorama, image::CubeMap& cube)
{
    const CubeChain chain = resampled(panorama, std::countr_zero(static_cast<unsigned>(cube.size)));
    tbb::parallel_for(0, 6 * cube.size, [&](int row) {
        const int face = row / cube.size, y = row % cube.size;
        for (int x = 0; x < cube.size; ++x) {
            const std::uint16_t* halfs = chain.halfs() + 3 * chain.texel(0, face, x, y);
            for (int k = 0; k < 3; ++k)
                cube.pixel(0, face, x, y)[k] = chain.scale * from_half(halfs[k]);
        }
    });
}

// A panorama of at least a given size; it is copied only if it must be enlarged.
struct Enlarged {
    const Panorama& given;
    Panorama copy;
    const Panorama& panorama;

    Enlarged(const Panorama& from, int width, int height)
        : given(from),
          copy(from.width < width || from.height < height ? at_least(from, width, height) : Panorama{}),
          panorama(copy.width > 0 ? copy : from)
    {
    }

    // How a check has to interpret the texels of the panorama as given.
    TexelMeaning meaning() const { return copy.width > 0 ? TexelMeaning::knots : TexelMeaning::points; }
};

void check(const BakeOptions& options)
{
    if (options.size < 1 || options.size > 4096 || !std::has_single_bit(static_cast<unsigned>(options.size)))
        throw Error(Failure::usage,
                    text("a face size of ", options.size, " texels is not a power of two from 1 to 4096"));
    if (!(options.error >= 0.0005 && options.error <= 0.2))
        throw Error(Failure::usage, text("an error of ", options.error, " is not from 0.0005 to 0.2"));
}

// Fills the levels of roughness above 0. Levels whose measured error is too large are filled again, more finely.
void fill_rough_levels(const Enlarged& large, const BakeOptions& options, BakedSpecular& baked,
                       const std::function<void(double)>& report, const FillFaces& fill)
{
    std::vector<CheckedLevel> left;
    for (int level = 0; level < baked.cube.levels; ++level)
        if (const double roughness = baked.levels[static_cast<std::size_t>(level)].perceptual_roughness;
            roughness > 0.0)
            left.push_back({level, lobe_of(options, roughness)});
    if (left.empty())
        return;
    double fineness = usual_fineness * std::pow(0.01 / options.error, 0.25);
    const LightTree tree(large.panorama, finest_extent(left.front().lobe, fineness));
    double done = 0.0;
    for (int round = 0; round < most_rounds && !left.empty(); ++round, fineness *= 1.6) {
        std::vector<PrefilteredFaces> faces;
        faces.reserve(left.size());
        for (const CheckedLevel& level : left)
            faces.push_back({baked.cube, level.level, Prefilter(tree, level.lobe, fineness)});
        fill(faces, [&](double share) {
            done = std::max(done, share); // further rounds start at 0 again, and are short
            if (report)
                report(done);
        });
        const std::vector<double> errors = check_levels(large.given, large.meaning(), baked.cube, left);
        for (std::size_t i = left.size(); i-- > 0;) {
            baked.levels[static_cast<std::size_t>(left[i].level)].error = errors[i];
            if (errors[i] <= options.error)
                left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }
}

} // namespace

BakedSpecular bake_specular(const Panorama& panorama, const BakeOptions& options,
                            const std::function<void(double)>& report, const FillFaces& fill)
{
    check(options);
    const Enlarged large(panorama, 1024, 512);
    const int levels = image::full_levels(options.size);
    BakedSpecular baked{image::make_cube_map(options.size, levels), {}};
    for (int level = 0; level < levels; ++level)
        baked.levels.push_back({roughness_of(options, level, levels), 0.0});
    fill_sharp(large.panorama, baked.cube);
    fill_rough_levels(large, options, baked, report, fill);
    return baked;
}

image::CubeMap bake_irradiance(const Panorama& panorama, int size, const FillFaces& fill)
{
    if (size < 1 || size > 4096)
        throw Error(Failure::usage,
                    text("an irradiance face size of ", size, " texels is not from 1 to 4096"));
    const Enlarged large(panorama, 64, 32);
    image::CubeMap cube = image::make_cube_map(size, 1);
    const LightTree tree(large.panorama, irradiance_extent);
    fill({{cube, 0, Prefilter(tree, phong_lobe(1.0), irradiance_fineness)}}, {});
    for (float& value : cube.values)
        value *= std::numbers::pi_v<float>;
    return cube;
}

std::vector<double> irradiance_coefficients(const HarmonicLight& light)
{
    constexpr double pi = std::numbers::pi;
    constexpr double band[3] = {pi, 2.0 * pi / 3.0, pi / 4.0};
    std::vector<double> coefficients;
    for (std::size_t i = 0; i < 9; ++i)
        for (std::size_t channel = 0; channel < 3; ++channel)
            coefficients.push_back(light[channel][i] * band[i == 0 ? 0 : i < 4 ? 1 : 2]);
    return coefficients;
}

} // namespace lambent::environment
