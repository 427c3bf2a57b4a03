#include "environment/bake.h"

#include "base/text.h"
#include "environment/cube_faces.h"
#include "environment/environment.h"
#include "environment/prefilter.h"
#include "equations/in_double.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <mutex>
#include <numbers>
#include <random>

namespace lambent::environment {
namespace {

constexpr int checks_per_level = 4; // at random texels, and as many at those of most light
constexpr int most_rounds = 3;
constexpr int tile_side = 4;

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

Direction texel_direction(int face, int x, int y, int size)
{
    return cube_direction(face, (2.0 * x + 1.0) / size - 1.0, (2.0 * y + 1.0) / size - 1.0);
}

// All of a level, tile by tile.
class Level {
public:
    Level(image::CubeMap& cube, int level) : cube_(cube), level_(level), size_(cube.face_size(level)) {}

    void prefilter(const LightTree& tree, const PrefilterLobe& lobe, double fineness,
                   const std::function<void(double)>& step) const
    {
        const int across = (size_ + tile_side - 1) / tile_side;
        tbb::enumerable_thread_specific<CellList> cells;
        tbb::parallel_for(0, 6 * across * across, [&](int index) {
            const int face = index / (across * across), in_face = index % (across * across);
            fill(tree, lobe, fineness, cells.local(),
                 {face, in_face % across * tile_side, in_face / across * tile_side});
            step(1.0 / (6.0 * across * across));
        });
    }

private:
    struct Corner {
        int face, x, y;
    };

    void fill(const LightTree& tree, const PrefilterLobe& lobe, double fineness, CellList& cells,
              Corner at) const
    {
        PrefilterTile tile;
        const int x1 = std::min(at.x + tile_side, size_), y1 = std::min(at.y + tile_side, size_);
        for (int y = at.y; y < y1; ++y)
            for (int x = at.x; x < x1; ++x, ++tile.count) {
                const Direction d = texel_direction(at.face, x, y, size_);
                tile.x[tile.count] = static_cast<float>(d.x);
                tile.y[tile.count] = static_cast<float>(d.y);
                tile.z[tile.count] = static_cast<float>(d.z);
            }
        prefilter_tile(tree, lobe, fineness, cells, tile);
        std::size_t i = 0;
        for (int y = at.y; y < y1; ++y)
            for (int x = at.x; x < x1; ++x, ++i)
                for (std::size_t k = 0; k < 3; ++k)
                    cube_.pixel(level_, at.face, x, y)[k] = tile.rgb[k][i];
    }

    image::CubeMap& cube_;
    int level_, size_;
};

struct Check {
    int level, face, x, y;
};

// Random texels of a level, and random ones around its brightest.
std::vector<Check> choose_checks(const image::CubeMap& cube, int level, std::mt19937& random)
{
    const int size = cube.face_size(level);
    std::uniform_int_distribution<int> faces(0, 5), texels(0, size - 1), near(-size / 16 - 1, size / 16 + 1);
    Check brightest{level, 0, 0, 0};
    float most = -1.0f;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                if (const float* c = cube.pixel(level, face, x, y); c[1] > most) {
                    most = c[1];
                    brightest = {level, face, x, y};
                }
    std::vector<Check> checks;
    for (int i = 0; i < checks_per_level; ++i) {
        checks.push_back({level, faces(random), texels(random), texels(random)});
        checks.push_back({level, brightest.face, std::clamp(brightest.x + near(random), 0, size - 1),
                          std::clamp(brightest.y + near(random), 0, size - 1)});
    }
    return checks;
}

// Relative RMSE of each level's checks; random ones and those at the brightest apart, the larger counts.
void measure(const Panorama& panorama, const BakeOptions& options, const std::vector<int>& which,
             BakedSpecular& baked)
{
    std::mt19937 random(20140601u + static_cast<unsigned>(which.size()));
    std::vector<Check> checks;
    std::vector<TexelSum> sums;
    for (int level : which)
        for (const Check& c : choose_checks(baked.cube, level, random)) {
            const Direction d = texel_direction(c.face, c.x, c.y, baked.cube.face_size(level));
            checks.push_back(c);
            sums.push_back(
                {d.x,
                 d.y,
                 d.z,
                 lobe_of(options, baked.levels[static_cast<std::size_t>(level)].perceptual_roughness),
                 {}});
        }
    sum_texels(panorama, sums);
    struct Error {
        double square = 0.0, mean = 0.0;
    };
    std::vector<Error> errors(2 * baked.levels.size());
    for (std::size_t i = 0; i < checks.size(); ++i) {
        const Check& c = checks[i];
        Error& e = errors[2 * static_cast<std::size_t>(c.level) + i % 2];
        for (std::size_t k = 0; k < 3; ++k) {
            const double off =
                static_cast<double>(baked.cube.pixel(c.level, c.face, c.x, c.y)[k]) - sums[i].rgb[k];
            e.square += off * off;
            e.mean += sums[i].rgb[k];
        }
    }
    constexpr double count = 3.0 * checks_per_level;
    for (int level : which) {
        double& error = baked.levels[static_cast<std::size_t>(level)].error;
        error = 0.0;
        for (std::size_t part = 0; part < 2; ++part) {
            const Error& e = errors[2 * static_cast<std::size_t>(level) + part];
            if (e.mean > 0.0)
                error = std::max(error, std::sqrt(e.square / count) / (e.mean / count));
        }
    }
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

class Progress {
public:
    Progress(const std::function<void(double)>& report, double all) : report_(report), all_(all) {}

    void add(double work)
    {
        if (!report_)
            return;
        const std::lock_guard lock(mutex_);
        done_ += work;
        report_(std::min(done_ / all_, 1.0));
    }

private:
    const std::function<void(double)>& report_;
    std::mutex mutex_;
    double all_, done_ = 0.0;
};

// Cells a tile meets are as many for each level, but for the narrow ones: texels are the work.
double work_of(const image::CubeMap& cube, int level)
{
    return static_cast<double>(cube.face_floats(level)) + 1000.0;
}

} // namespace

BakedSpecular bake_specular(const Panorama& given, const BakeOptions& options,
                            const std::function<void(double)>& report)
{
    check(options);
    const Panorama panorama = at_least(given, 1024, 512);
    const int levels = image::full_levels(options.size);
    BakedSpecular baked{image::make_cube_map(options.size, levels), {}};
    std::vector<int> left;
    double all = 0.0;
    for (int level = 0; level < levels; ++level) {
        baked.levels.push_back({roughness_of(options, level, levels), 0.0});
        if (baked.levels.back().perceptual_roughness > 0.0)
            left.push_back(level), all += work_of(baked.cube, level);
    }
    fill_sharp(panorama, baked.cube);
    if (left.empty())
        return baked;
    Progress progress(report, all);
    const double narrowest =
        lobe_of(options, baked.levels[static_cast<std::size_t>(left.front())].perceptual_roughness).alpha;
    double fineness = 4.0 * std::pow(0.01 / options.error, 0.25);
    const LightTree tree = make_light_tree(panorama, 2.0 * narrowest / fineness);
    for (int round = 0; round < most_rounds && !left.empty(); ++round, fineness *= 1.6) {
        for (int level : left)
            Level(baked.cube, level)
                .prefilter(
                    tree,
                    lobe_of(options, baked.levels[static_cast<std::size_t>(level)].perceptual_roughness),
                    fineness, [&](double share) { progress.add(share * work_of(baked.cube, level)); });
        measure(panorama, options, left, baked);
        std::erase_if(left, [&](int level) {
            return baked.levels[static_cast<std::size_t>(level)].error <= options.error;
        });
    }
    return baked;
}

image::CubeMap bake_irradiance(const Panorama& given, int size)
{
    if (size < 1 || size > 4096)
        throw Error(Failure::usage, text("irradiance faces of ", size, " texels: 1 to 4096 are possible"));
    const Panorama panorama = at_least(given, 64, 32);
    image::CubeMap cube = image::make_cube_map(size, 1);
    const PrefilterLobe cosine = phong_lobe(1.0);
    constexpr double fineness = 5.0;
    const LightTree tree = make_light_tree(panorama, 0.02);
    Level(cube, 0).prefilter(tree, cosine, fineness, [](double) {});
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
