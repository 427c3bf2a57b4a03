#include "environment/light_tree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::environment {
namespace {

constexpr int most_columns = 2048, least_columns = 32;

constexpr double least_weight = 1e-18;

// What a cell is made of: sums over its parts.
struct Sums {
    double light[3] = {}, moment[3] = {}, weight = 0.0, variance = 0.0;

    void add(const LightCell& cell)
    {
        const double rgb[3] = {cell.r, cell.g, cell.b}, direction[3] = {cell.x, cell.y, cell.z};
        // Cells without light have a middle, too.
        const double w = rgb[0] + rgb[1] + rgb[2] + least_weight;
        for (int k = 0; k < 3; ++k) {
            light[k] += rgb[k];
            moment[k] += w * direction[k];
        }
        weight += w;
        variance += w * static_cast<double>(cell.variance);
    }

    LightCell cell() const
    {
        const double length =
            std::sqrt(moment[0] * moment[0] + moment[1] * moment[1] + moment[2] * moment[2]);
        // Unit vectors have a mean that falls short of 1 by their variance.
        const double spread = std::max(0.5 * (1.0 - (length / weight) * (length / weight)), 0.0);
        LightCell cell;
        cell.x = static_cast<float>(moment[0] / length);
        cell.y = static_cast<float>(moment[1] / length);
        cell.z = static_cast<float>(moment[2] / length);
        cell.variance = static_cast<float>(spread + variance / weight);
        cell.r = static_cast<float>(light[0]);
        cell.g = static_cast<float>(light[1]);
        cell.b = static_cast<float>(light[2]);
        return cell;
    }
};

LightCellLevel make_level(int width, int height)
{
    LightCellLevel level;
    level.width = width;
    level.height = height;
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

} // namespace

LightCellLevel LightTree::coarser() const
{
    const std::size_t depth = levels_.size() - 1;
    const int width = levels_[depth].width, height = levels_[depth].height;
    LightCellLevel level = make_level((width + 1) / 2, (height + 1) / 2);
    level.cells.resize(level.index(0, level.height));
    tbb::parallel_for(0, level.height, [&](int row) {
        for (int column = 0; column < level.width; ++column) {
            Sums sums;
            for (int y = 2 * row; y < std::min(2 * row + 2, height); ++y)
                for (int x = 2 * column; x < std::min(2 * column + 2, width); ++x)
                    sums.add(cell(depth, x, y));
            level.cells[level.index(column, row)] = sums.cell();
        }
    });
    return level;
}

// Of all texels whose middle is in each cell.
LightCellLevel LightTree::gathered(int width, int height) const
{
    LightCellLevel level = make_level(width, height);
    level.cells.resize(level.index(0, height));
    const auto first = [&](int row) {
        return static_cast<int>((std::int64_t{row} * panorama_.height + height - 1) / height);
    };
    tbb::parallel_for(0, height, [&](int row) {
        std::vector<Sums> sums(static_cast<std::size_t>(width));
        for (int y = first(row); y < first(row + 1); ++y)
            for (int x = 0; x < panorama_.width; ++x)
                sums[static_cast<std::size_t>(std::int64_t{x} * width / panorama_.width)].add(texel(x, y));
        for (int column = 0; column < width; ++column)
            level.cells[level.index(column, row)] = sums[static_cast<std::size_t>(column)].cell();
    });
    return level;
}

LightTree::LightTree(const Panorama& panorama, double extent) : panorama_(panorama)
{
    for (int x = 0; x < panorama.width; ++x) {
        const double phi = ((x + 0.5) / panorama.width - 0.5) * 2.0 * std::numbers::pi;
        turns_.push_back({static_cast<float>(std::cos(phi)), static_cast<float>(std::sin(phi))});
    }
    for (int y = 0; y < panorama.height; ++y) {
        const double theta = (y + 0.5) / panorama.height * std::numbers::pi;
        rows_.push_back({static_cast<float>(std::cos(theta)), static_cast<float>(std::sin(theta)),
                         static_cast<float>(texel_solid_angle(panorama, y))});
    }
    int width = panorama.width, height = panorama.height;
    while (width > most_columns || (width > least_columns && 4.0 * std::numbers::pi / width < extent)) {
        width = (width + 1) / 2;
        height = std::max((height + 1) / 2, 1);
    }
    levels_.push_back(width == panorama.width ? make_level(width, height) : gathered(width, height));
    while (levels_.back().width > least_columns)
        levels_.push_back(coarser());
}

} // namespace lambent::environment
