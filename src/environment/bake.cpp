#include "environment/bake.h"

#include "base/text.h"
#include "environment/bake_check.h"
#include "environment/environment.h"
#include "environment/prefilter.h"
#include "equations/in_double.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <mutex>
#include <numbers>

namespace lambent::environment {
namespace {

constexpr int most_rounds = 3;
constexpr double usual_fineness = 1.0; // for an error of 0.01
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

constexpr int tile_side = 4, patch_side = 32;

// Of a level's face, up to patch_side texels wide and high.
struct Place {
    int level, face, x, y;
};

// Every second bit.
int every_second(std::size_t bits)
{
    int value = 0;
    for (int i = 0; i < 8; ++i)
        value |= static_cast<int>(bits >> (2 * i) & 1) << i;
    return value;
}

// Calls visit(x, y, index in the patch) for each texel of it, tile by tile; returns how many tiles. Tiles are in the
// order of a quadtree, so that those one after the other are near.
template <class Visit>
std::size_t for_each_texel(const Place& place, int size, const Visit& visit)
{
    constexpr std::size_t all = (patch_side / tile_side) * (patch_side / tile_side);
    std::size_t tiles = 0;
    for (std::size_t i = 0; i < all; ++i) {
        const int left = place.x + tile_side * every_second(i),
                  top = place.y + tile_side * every_second(i >> 1);
        if (left >= size || top >= size)
            continue;
        std::size_t at = PrefilterPatch::tile * tiles++;
        for (int y = top; y < std::min(top + tile_side, size); ++y)
            for (int x = left; x < std::min(left + tile_side, size); ++x)
                visit(x, y, at++);
    }
    return tiles;
}

struct Worker {
    PrefilterPatch patch;
    Prefilter::Scratch scratch;

    void fill(image::CubeMap& cube, const Place& place, const Prefilter& prefilter)
    {
        const int size = cube.face_size(place.level);
        // What no texel sets repeats one, as a patch wants it.
        const Direction first = texel_direction({place.face, place.x, place.y, size});
        std::fill(std::begin(patch.x), std::end(patch.x), static_cast<float>(first.x));
        std::fill(std::begin(patch.y), std::end(patch.y), static_cast<float>(first.y));
        std::fill(std::begin(patch.z), std::end(patch.z), static_cast<float>(first.z));
        patch.tiles = for_each_texel(place, size, [&](int x, int y, std::size_t at) {
            const Direction d = texel_direction({place.face, x, y, size});
            patch.x[at] = static_cast<float>(d.x);
            patch.y[at] = static_cast<float>(d.y);
            patch.z[at] = static_cast<float>(d.z);
        });
        prefilter.fill(patch, scratch);
        for_each_texel(place, size, [&](int x, int y, std::size_t at) {
            float* texel = cube.pixel(place.level, place.face, x, y);
            texel[0] = patch.dim.r[at], texel[1] = patch.dim.g[at], texel[2] = patch.dim.b[at];
        });
    }
};

class Progress {
public:
    explicit Progress(const std::function<void(double)>& report) : report_(report) {}

    void add(double share)
    {
        if (!report_)
            return;
        const std::lock_guard lock(mutex_);
        done_ += share;
        report_(std::min(done_, 1.0));
    }

private:
    std::function<void(double)> report_;
    std::mutex mutex_;
    double done_ = 0.0;
};

struct Work {
    Place place;
    const Prefilter* prefilter;
};

void add_work(const image::CubeMap& cube, int level, const Prefilter& prefilter, std::vector<Work>& work)
{
    const int size = cube.face_size(level);
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < size; y += patch_side)
            for (int x = 0; x < size; x += patch_side)
                work.push_back({{level, face, x, y}, &prefilter});
}

void fill(image::CubeMap& cube, const std::vector<Work>& work, Progress& progress)
{
    tbb::enumerable_thread_specific<Worker> workers;
    tbb::parallel_for(std::size_t{0}, work.size(), [&](std::size_t i) {
        workers.local().fill(cube, work[i].place, *work[i].prefilter);
        progress.add(1.0 / static_cast<double>(work.size()));
    });
}

// The panorama itself, as sharp as the faces: the mean of bilinear lookups over each texel.
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

void check(const BakeOptions& options)
{
    if (options.size < 1 || options.size > 4096 || !std::has_single_bit(static_cast<unsigned>(options.size)))
        throw Error(Failure::usage,
                    text("faces of ", options.size, " texels: a power of two up to 4096 is possible"));
    if (!(options.error >= 0.0005 && options.error <= 0.2))
        throw Error(Failure::usage, text("an error of ", options.error, ": 0.0005 to 0.2 is possible"));
}

// Of level after level what an error asks for, until a check finds it there.
void fill_rough_levels(const Panorama& panorama, const BakeOptions& options, BakedSpecular& baked,
                       Progress& progress)
{
    std::vector<CheckedLevel> left;
    for (int level = 0; level < baked.cube.levels; ++level)
        if (const double roughness = baked.levels[static_cast<std::size_t>(level)].perceptual_roughness;
            roughness > 0.0)
            left.push_back({level, lobe_of(options, roughness)});
    if (left.empty())
        return;
    double fineness = usual_fineness * std::pow(0.01 / options.error, 0.25);
    const LightTree tree(panorama, finest_extent(left.front().lobe, fineness));
    for (int round = 0; round < most_rounds && !left.empty(); ++round, fineness *= 1.6) {
        std::vector<Work> work;
        std::vector<Prefilter> prefilters;
        prefilters.reserve(left.size());
        for (const CheckedLevel& level : left) {
            prefilters.emplace_back(tree, level.lobe, fineness);
            add_work(baked.cube, level.level, prefilters.back(), work);
        }
        fill(baked.cube, work, progress);
        const std::vector<double> errors = check_levels(panorama, baked.cube, left);
        for (std::size_t i = left.size(); i-- > 0;) {
            baked.levels[static_cast<std::size_t>(left[i].level)].error = errors[i];
            if (errors[i] <= options.error)
                left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }
}

} // namespace

BakedSpecular bake_specular(const Panorama& given, const BakeOptions& options,
                            const std::function<void(double)>& report)
{
    check(options);
    const Panorama panorama = at_least(given, 1024, 512);
    const int levels = image::full_levels(options.size);
    BakedSpecular baked{image::make_cube_map(options.size, levels), {}};
    for (int level = 0; level < levels; ++level)
        baked.levels.push_back({roughness_of(options, level, levels), 0.0});
    Progress progress(report);
    fill_sharp(panorama, baked.cube);
    fill_rough_levels(panorama, options, baked, progress);
    return baked;
}

image::CubeMap bake_irradiance(const Panorama& given, int size)
{
    if (size < 1 || size > 4096)
        throw Error(Failure::usage, text("irradiance faces of ", size, " texels: 1 to 4096 are possible"));
    const Panorama panorama = at_least(given, 64, 32);
    image::CubeMap cube = image::make_cube_map(size, 1);
    const LightTree tree(panorama, irradiance_extent);
    const Prefilter cosine(tree, phong_lobe(1.0), irradiance_fineness);
    std::vector<Work> work;
    add_work(cube, 0, cosine, work);
    Progress none({});
    fill(cube, work, none);
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
