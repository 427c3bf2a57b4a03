#include "environment/light_tree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::environment {
namespace {

constexpr int most_columns = 2048, least_columns = 32;

// What a cell is made of: sums over its parts.
struct Sums {
    double light[3] = {}, moment[3] = {}, weight = 0.0, variance = 0.0;

    // `w` is a share of the light that says how much a direction counts.
    void add(const double* direction, const double* rgb, double w, double own_variance)
    {
        for (int k = 0; k < 3; ++k) {
            light[k] += rgb[k];
            moment[k] += w * direction[k];
        }
        weight += w;
        variance += w * own_variance;
    }

    void store(LightCellLevel& level, std::size_t at) const
    {
        const double length = std::hypot(moment[0], moment[1], moment[2]);
        level.x[at] = static_cast<float>(moment[0] / length);
        level.y[at] = static_cast<float>(moment[1] / length);
        level.z[at] = static_cast<float>(moment[2] / length);
        level.r[at] = static_cast<float>(light[0]);
        level.g[at] = static_cast<float>(light[1]);
        level.b[at] = static_cast<float>(light[2]);
        // Unit vectors have a mean that falls short of 1 by their variance.
        const double spread = std::max(0.5 * (1.0 - (length / weight) * (length / weight)), 0.0);
        level.variance[at] = static_cast<float>(spread + variance / weight);
    }
};

LightCellLevel make_level(int width, int height)
{
    LightCellLevel level;
    level.width = width;
    level.height = height;
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    for (auto* column : {&level.x, &level.y, &level.z, &level.r, &level.g, &level.b, &level.variance})
        column->resize(count);
    for (int row = 0; row < height; ++row) {
        const double top = std::numbers::pi * row / height, bottom = std::numbers::pi * (row + 1) / height;
        const double sine = row < height / 2 && bottom > std::numbers::pi / 2
                                ? 1.0
                                : std::max(std::sin(top), std::sin(bottom));
        level.extent.push_back(
            static_cast<float>(std::max(std::numbers::pi / height, sine * 2.0 * std::numbers::pi / width)));
    }
    return level;
}

// Texels weigh by their light, and a little by their area: cells without light have a middle, too.
constexpr double least_weight = 1e-12;

class TexelGatherer {
public:
    explicit TexelGatherer(const Panorama& panorama) : panorama_(panorama)
    {
        for (int x = 0; x < panorama.width; ++x) {
            const double phi = ((x + 0.5) / panorama.width - 0.5) * 2.0 * std::numbers::pi;
            cosine_.push_back(std::cos(phi));
            sine_.push_back(std::sin(phi));
        }
    }

    // Row `row` of the level, of all texels whose middle is in it.
    void gather(int row, LightCellLevel& level) const
    {
        const auto first = [&](int cell, int texels, int cells) {
            return static_cast<int>((std::int64_t{cell} * texels + cells - 1) / cells);
        };
        std::vector<Sums> sums(static_cast<std::size_t>(level.width));
        for (int y = first(row, panorama_.height, level.height);
             y < first(row + 1, panorama_.height, level.height); ++y)
            add_row(y, sums);
        for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i].store(level, static_cast<std::size_t>(row) * sums.size() + i);
    }

private:
    void add_row(int y, std::vector<Sums>& sums) const
    {
        const double area = texel_solid_angle(panorama_, y);
        const double theta = (y + 0.5) / panorama_.height * std::numbers::pi;
        const double ring = std::sin(theta), up = std::cos(theta);
        const auto cells = static_cast<std::int64_t>(sums.size());
        for (int x = 0; x < panorama_.width; ++x) {
            const Rgb c = panorama_.radiance(x, y);
            const double rgb[3] = {area * static_cast<double>(c.r), area * static_cast<double>(c.g),
                                   area * static_cast<double>(c.b)};
            const double d[3] = {ring * cosine_[static_cast<std::size_t>(x)], up,
                                 ring * sine_[static_cast<std::size_t>(x)]};
            const auto cell = static_cast<std::size_t>(x * cells / panorama_.width);
            sums[cell].add(d, rgb, rgb[0] + rgb[1] + rgb[2] + least_weight * area, 0.0);
        }
    }

    const Panorama& panorama_;
    std::vector<double> cosine_, sine_;
};

LightCellLevel coarser(const LightCellLevel& fine)
{
    LightCellLevel level = make_level((fine.width + 1) / 2, (fine.height + 1) / 2);
    tbb::parallel_for(0, level.height, [&](int row) {
        for (int column = 0; column < level.width; ++column) {
            Sums sums;
            for (int y = 2 * row; y < std::min(2 * row + 2, fine.height); ++y)
                for (int x = 2 * column; x < std::min(2 * column + 2, fine.width); ++x) {
                    const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(fine.width) +
                                    static_cast<std::size_t>(x);
                    const double d[3] = {fine.x[at], fine.y[at], fine.z[at]};
                    const double rgb[3] = {fine.r[at], fine.g[at], fine.b[at]};
                    sums.add(d, rgb, rgb[0] + rgb[1] + rgb[2] + least_weight * 1e-6,
                             static_cast<double>(fine.variance[at]));
                }
            sums.store(level, static_cast<std::size_t>(row) * static_cast<std::size_t>(level.width) +
                                  static_cast<std::size_t>(column));
        }
    });
    return level;
}

} // namespace

LightTree make_light_tree(const Panorama& panorama, double extent)
{
    int width = panorama.width, height = panorama.height;
    while (width > most_columns || (width > least_columns && 4.0 * std::numbers::pi / width < extent)) {
        width = (width + 1) / 2;
        height = std::max((height + 1) / 2, 1);
    }
    LightTree tree;
    tree.levels.push_back(make_level(width, height));
    const TexelGatherer gatherer(panorama);
    tbb::parallel_for(0, height, [&](int row) { gatherer.gather(row, tree.levels.front()); });
    while (tree.levels.back().width > least_columns)
        tree.levels.push_back(coarser(tree.levels.back()));
    return tree;
}

} // namespace lambent::environment
