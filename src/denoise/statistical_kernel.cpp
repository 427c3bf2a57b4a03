#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "denoise/statistical_kernel.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"

#include "denoise/statistical_planes.h"

#include <algorithm>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace lambent::denoise::HWY_NAMESPACE {
namespace {

#include "wide/wide.h"
#include "denoise/welch.h"

constexpr int lanes = static_cast<int>(lane_count);

// What the neighbours' variance counts beside a pixel's own, in degrees of freedom.
constexpr float prior_freedom = 4.0f;
constexpr int prior_reach = 2;

// Means of floats are exact to about this, relative.
constexpr float rounding = 1.0e-5f;

// Tests of 3 x 3 pixels: their mean ratio is about 0.17 if all means are equal. Below the first a pixel counts fully,
// from the second on not at all. One pixel's ratio counts at most `most_ratio`, as noise is not normal.
constexpr float patch_equal = 0.2f, patch_different = 0.4f, most_ratio = 1.0f;

using Planes = StatisticalPlanes;

// A pixel, or from one to another.
struct Step {
    int x, y;
};

HWY_INLINE Step operator+(Step a, Step b)
{
    return {a.x + b.x, a.y + b.y};
}

constexpr int squared_radius = (filter_reach + 1) * (filter_reach + 1);

constexpr int squared_length(Step a)
{
    return a.x * a.x + a.y * a.y;
}

HWY_INLINE Real load_plane(const Planes& p, int plane, Step at)
{
    return load(p.at(plane, at.x, at.y));
}

// Normals, depths and slopes of one vector of pixels.
struct Surfaces {
    Real normal_x, normal_y, normal_z, depth, slope_x, slope_y;
};

HWY_INLINE Surfaces surfaces_at(const Planes& p, Step at)
{
    return {load_plane(p, surface_plane, at),
            load_plane(p, surface_plane + 1, at),
            load_plane(p, surface_plane + 2, at),
            load_plane(p, surface_plane + surface_depth, at),
            load_plane(p, surface_plane + surface_slope_x, at),
            load_plane(p, surface_plane + surface_slope_y, at)};
}

// A weight in [0, 1] for the surfaces of two pixels: 1 less the squared difference of normals over 0.25 (29 degrees), less
// the distance from each other's planes over 2 % of the depth and the slope between; squared. 0 if one takes no part.
HWY_INLINE Real likeness(const Planes& planes, Step at, Step by)
{
    const Surfaces p = surfaces_at(planes, at), q = surfaces_at(planes, at + by);
    const Real x = p.normal_x - q.normal_x, y = p.normal_y - q.normal_y, z = p.normal_z - q.normal_z;
    const Real slope = (0.5f * static_cast<float>(by.x)) * (p.slope_x + q.slope_x) +
                       (0.5f * static_cast<float>(by.y)) * (p.slope_y + q.slope_y);
    const Real distance = abs(q.depth - p.depth - slope);
    const Real tolerance = 0.01 * (p.depth + q.depth) + abs(slope) + 1.0e-12;
    const Real left = max(1.0 - 4.0 * (x * x + y * y + z * z) - distance / tolerance, 0.0);
    return left * left * load_plane(planes, usable_plane, at) * load_plane(planes, usable_plane, at + by);
}

// Weighed sums over the neighbours of a vector of pixels.
struct Prior {
    Real weight, known; // of all, and of those whose variance is known
    Real variance[3], light[3], squares[3];
};

HWY_INLINE void add_neighbour(const Planes& p, Step at, Step by, Prior& prior)
{
    const Step there = at + by;
    const Real weight = likeness(p, at, by);
    const Real share = weight * load_plane(p, coverage_plane, there); // fewer samples vary more
    prior.weight += weight;
    prior.known += select(load_plane(p, freedom_plane, there) > 0.0, weight, 0.0);
    for (int c = 0; c < 3; ++c) {
        const Real light = load_plane(p, reflected_plane + c, there) - load_plane(p, reflected_plane + c, at);
        prior.variance[c] += share * load_plane(p, own_variance_plane + c, there);
        prior.light[c] += weight * light;
        prior.squares[c] += weight * light * light;
    }
}

// The mean of the known variances; without any the variance of the neighbours' light; without neighbours the light's
// square.
HWY_INLINE Real prior_variance(const Prior& prior, int c, Real light)
{
    const Real sum = max(prior.weight, 1.0e-6), mean = prior.light[c] / sum;
    const Real spread = max(prior.squares[c] / sum - mean * mean, 0.0) * sum / max(sum - 1.0, 0.5);
    return select(prior.known > 0.0, prior.variance[c] / max(prior.known, 1.0e-6),
                  select(prior.weight > 1.5, spread, light * light));
}

// A tile compared with its pixels' neighbours in one direction. Row and column 0 are those before the tile's first.
struct Compared {
    static constexpr int rows = FilterTile::most_rows + 2;
    static constexpr int columns = FilterTile::most_columns + 2 + 2 * static_cast<int>(max_lanes);
    float ratios[rows][columns]; // mean of the channels' tests, times likeness
    float alike[rows][columns];  // likeness
    float passed[rows][columns]; // likeness; 0 where a test tells the pixels apart
};

// A tile on its way through all directions.
struct Work {
    const Planes& planes;
    const FilterTile& tile;
    Compared compared;
    float sums[4][FilterTile::most_rows]
              [FilterTile::most_columns + max_lanes]; // weighed: light, and the weights
};

HWY_INLINE void compare_row(Work& work, int row, Step by)
{
    const Planes& p = work.planes;
    for (int i = 0; i < work.tile.columns + 2; i += lanes) {
        const Step at = {work.tile.x + i - 1, work.tile.y + row - 1}, there = at + by;
        const Real alike = likeness(p, at, by);
        Real sum = 0.0, worst = 0.0;
        if (any_of(alike > 0.0)) {
            const Real inverse = load_plane(p, inverse_plane, at),
                       other = load_plane(p, inverse_plane, there);
            for (int c = 0; c < 3; ++c) {
                const Real difference =
                    load_plane(p, reflected_plane + c, at) - load_plane(p, reflected_plane + c, there);
                const Real ratio = welch_ratio(difference, load_plane(p, variance_plane + c, at), inverse,
                                               load_plane(p, variance_plane + c, there), other);
                sum += min(ratio, most_ratio);
                worst = max(worst, ratio);
            }
        }
        store(alike * sum * (1.0 / 3.0), work.compared.ratios[row] + i);
        store(alike, work.compared.alike[row] + i);
        store(select(worst > 1.0, 0.0, alike), work.compared.passed[row] + i);
    }
}

// Sum over the 3 x 3 values around column i of row y.
HWY_INLINE Real around(const float (*rows)[Compared::columns], int y, int i)
{
    Real sum = 0.0;
    for (int j = y - 1; j <= y + 1; ++j)
        sum += load(rows[j] + i - 1) + load(rows[j] + i) + load(rows[j] + i + 1);
    return sum;
}

HWY_INLINE void add_row(Work& work, int row, Step by)
{
    const float near = 1.0f - static_cast<float>(squared_length(by)) / squared_radius;
    const Compared& compared = work.compared;
    for (int i = 0; i < work.tile.columns; i += lanes) {
        const Real passed = load(compared.passed[row + 1] + i + 1);
        if (none(passed > 0.0))
            continue;
        const Real ratio =
            around(compared.ratios, row + 1, i + 1) / max(around(compared.alike, row + 1, i + 1), 1.0e-6);
        const Real equal =
            clamp((patch_different - ratio) * (1.0 / (patch_different - patch_equal)), 0.0, 1.0);
        const Step there = Step{work.tile.x + i, work.tile.y + row} + by;
        const Real weight = near * passed * equal * load_plane(work.planes, weight_plane, there);
        for (int c = 0; c < 3; ++c) {
            float* const to = work.sums[c][row] + i;
            store(load(to) + weight * load_plane(work.planes, reflected_plane + c, there), to);
        }
        float* const to = work.sums[3][row] + i;
        store(load(to) + weight, to);
    }
}

// Each pixel's own light always counts.
void begin(Work& work)
{
    for (int row = 0; row < work.tile.rows; ++row)
        for (int i = 0; i < work.tile.columns; ++i) {
            const int x = work.tile.x + i, y = work.tile.y + row;
            const float weight = *work.planes.at(weight_plane, x, y);
            for (int c = 0; c < 3; ++c)
                work.sums[c][row][i] = weight * *work.planes.at(reflected_plane + c, x, y);
            work.sums[3][row][i] = weight;
        }
}

void finish(const Work& work, Averages& to)
{
    const Planes& p = work.planes;
    for (int row = 0; row < work.tile.rows; ++row)
        for (int i = 0; i < work.tile.columns; ++i) {
            const int x = work.tile.x + i, y = work.tile.y + row;
            if (!(*p.at(usable_plane, x, y) > 0.0f))
                continue;
            const auto at = static_cast<size_t>(y) * static_cast<size_t>(p.width()) + static_cast<size_t>(x);
            const float sum = work.sums[3][row][i];
            for (int c = 0; c < 3; ++c)
                to.light[static_cast<size_t>(c)][at] = work.sums[c][row][i] / sum;
            to.own_share[at] = *p.at(weight_plane, x, y) / sum;
        }
}

} // namespace

HWY_FLATTEN void pool_variance_row(Planes& p, int y)
{
    for (int x = 0; x < p.width(); x += lanes) {
        const Step at = {x, y};
        const Mask usable = load_plane(p, usable_plane, at) > 0.0;
        if (none(usable))
            continue;
        Prior prior{0.0, 0.0, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
        for (int dy = -prior_reach; dy <= prior_reach; ++dy)
            for (int dx = -prior_reach; dx <= prior_reach; ++dx)
                add_neighbour(p, at, {dx, dy}, prior);
        const Real freedom = load_plane(p, freedom_plane, at), all = freedom + prior_freedom;
        const Real coverage = max(load_plane(p, coverage_plane, at), 1.0e-3);
        Real variances = 0.0, albedos = 0.0;
        for (int c = 0; c < 3; ++c) {
            const Real light = load_plane(p, reflected_plane + c, at), floor = rounding * light;
            const Real pooled = freedom * load_plane(p, own_variance_plane + c, at) +
                                prior_freedom * prior_variance(prior, c, light) / coverage;
            const Real variance = pooled / all + floor * floor + 1.0e-30;
            store(select(usable, variance, 1.0), p.at(variance_plane + c, x, y));
            variances += variance;
            albedos += load_plane(p, albedo_plane + c, at);
        }
        store(1.0 / all, p.at(inverse_plane, x, y));
        store(select(usable, albedos / sqrt(sqrt(variances)), 0.0), p.at(weight_plane, x, y));
    }
}

HWY_FLATTEN void average(const Planes& p, const FilterTile& tile, Averages& to)
{
    Work work{p, tile, {}, {}};
    begin(work);
    for (int dy = -filter_reach; dy <= filter_reach; ++dy)
        for (int dx = -filter_reach; dx <= filter_reach; ++dx) {
            const int distance = squared_length({dx, dy});
            if (distance == 0 || distance >= squared_radius)
                continue;
            for (int row = 0; row < tile.rows + 2; ++row)
                compare_row(work, row, {dx, dy});
            for (int row = 0; row < tile.rows; ++row)
                add_row(work, row, {dx, dy});
        }
    finish(work, to);
}

} // namespace lambent::denoise::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::denoise {

HWY_EXPORT(pool_variance_row);
HWY_EXPORT(average);

void pool_variance(StatisticalPlanes& planes, int y)
{
    HWY_DYNAMIC_DISPATCH(pool_variance_row)(planes, y);
}

void average_tile(const StatisticalPlanes& planes, const FilterTile& tile, Averages& to)
{
    HWY_DYNAMIC_DISPATCH(average)(planes, tile, to);
}

} // namespace lambent::denoise
#endif
