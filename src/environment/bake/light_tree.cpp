#include "environment/bake/light_tree.h"

#include "image/panorama_rows.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::environment {
namespace {

constexpr int most_columns = 2048, least_columns = 32;

// The weighted mean direction of a cell's parts, and their angular variance.
struct Moment {
    double sum[3] = {}, weight = 0.0, variance = 0.0;

    void add(const LightCell& cell, double w)
    {
        sum[0] += w * static_cast<double>(cell.x);
        sum[1] += w * static_cast<double>(cell.y);
        sum[2] += w * static_cast<double>(cell.z);
        weight += w;
        variance += w * static_cast<double>(cell.variance);
    }

    LightCell cell() const
    {
        const double square = sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2];
        const double over = 1.0 / std::sqrt(square);
        // The mean of unit vectors is shorter than 1 by their variance.
        const double spread = std::max(0.5 * (1.0 - square / (weight * weight)), 0.0);
        LightCell cell{};
        cell.x = static_cast<float>(over * sum[0]);
        cell.y = static_cast<float>(over * sum[1]);
        cell.z = static_cast<float>(over * sum[2]);
        cell.variance = static_cast<float>(spread + variance / weight);
        return cell;
    }
};

// Sums over the parts of a cell.
struct Sums {
    double rgb[3] = {};
    Moment light, area;

    void add(const LightCell& part, const LightCell& part_area)
    {
        const double r = part.r, g = part.g, b = part.b;
        rgb[0] += r, rgb[1] += g, rgb[2] += b;
        light.add(part, r + g + b);
        area.add(part_area, static_cast<double>(part_area.area));
    }
};

// Tolerances within which a cell's light and area share one centre and variance: the distance of the centres over the
// cell's extent, and the difference of the variances over its square.
constexpr float same_middle = 0.06f, same_variance = 0.03f;

// Makes the cell of these sums; returns true if its area needs a cell of its own, which is `area`.
bool split(const Sums& sums, float extent, LightCell& cell, LightCell& area)
{
    area = sums.area.cell();
    area.area = static_cast<float>(sums.area.weight);
    cell = sums.light.weight > 0.0 ? sums.light.cell() : area;
    cell.r = static_cast<float>(sums.rgb[0]);
    cell.g = static_cast<float>(sums.rgb[1]);
    cell.b = static_cast<float>(sums.rgb[2]);
    const float dx = cell.x - area.x, dy = cell.y - area.y, dz = cell.z - area.z, e2 = extent * extent;
    const bool same = dx * dx + dy * dy + dz * dz <= same_middle * same_middle * e2 &&
                      std::fabs(cell.variance - area.variance) <= same_variance * e2;
    cell.area = same ? area.area : 0.0f;
    return !same;
}

void store(const Sums& sums, LightCellLevel& level, int column, int row)
{
    LightCell area;
    std::vector<LightCell>& areas = level.areas[static_cast<std::size_t>(row)];
    const std::size_t at = level.index(column, row);
    if (split(sums, level.extent[static_cast<std::size_t>(row)], level.cells[at], area)) {
        level.area_index[at] = static_cast<std::uint16_t>(areas.size());
        areas.push_back(area);
    }
}

void allocate(LightCellLevel& level)
{
    const std::size_t count = level.index(0, level.height);
    level.cells.resize(count);
    level.area_index.resize(count);
    level.areas.resize(static_cast<std::size_t>(level.height));
}

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
    allocate(level);
    tbb::parallel_for(0, level.height, [&](int row) {
        for (int column = 0; column < level.width; ++column) {
            Sums sums;
            for (int y = 2 * row; y < std::min(2 * row + 2, height); ++y)
                for (int x = 2 * column; x < std::min(2 * column + 2, width); ++x) {
                    const LightCell part = cell(depth, x, y);
                    sums.add(part, part.area > 0.0f ? part : area(depth, x, y));
                }
            store(sums, level, column, row);
        }
    });
    return level;
}

// A level of cells that sum all texels whose centres they hold.
LightCellLevel LightTree::gathered(int width, int height) const
{
    LightCellLevel level = make_level(width, height);
    allocate(level);
    const auto first = [&](int row) {
        return static_cast<int>((std::int64_t{row} * panorama_.height + height - 1) / height);
    };
    tbb::parallel_for(0, height, [&](int row) {
        std::vector<Sums> sums(static_cast<std::size_t>(width));
        for (int y = first(row); y < first(row + 1); ++y)
            for (int x = 0; x < panorama_.width; ++x) {
                const LightCell part = texel(x, y);
                sums[static_cast<std::size_t>(std::int64_t{x} * width / panorama_.width)].add(part, part);
            }
        for (int column = 0; column < width; ++column)
            store(sums[static_cast<std::size_t>(column)], level, column, row);
    });
    return level;
}

LightTree::LightTree(const Panorama& panorama, double extent) : panorama_(panorama)
{
    for (int x = 0; x < panorama.width; ++x) {
        const double phi = image::column_azimuth(x + 0.5, panorama.width);
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
