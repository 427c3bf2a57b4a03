#include "environment/prefilter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::environment {
namespace {

// The cosine's kink at the horizon has no curvature to be corrected by: cells on it are smaller, the more so the more a
// lobe has there.
constexpr double horizon_extent = 0.05;

struct Walk {
    const LightTree& tree;
    double x = 0.0, y = 0.0, z = 0.0; ///< the tile's middle
    double radius = 0.0;              ///< of the tile, as a chord
    double core2 = 0.0;               ///< square of the lobe's width
    double fineness2 = 0.0;
    double at_horizon = 0.0; ///< largest extent there
    CellList& cells;

    void visit(std::size_t level, int column, int row);

private:
    bool is_fine(const LightCellLevel& cells, std::size_t at, int row, bool& unseen) const;
};

bool Walk::is_fine(const LightCellLevel& level, std::size_t at, int row, bool& unseen) const
{
    const double dx = static_cast<double>(level.x[at]) - x, dy = static_cast<double>(level.y[at]) - y,
                 dz = static_cast<double>(level.z[at]) - z;
    const double chord = std::sqrt(dx * dx + dy * dy + dz * dz);
    const double extent = static_cast<double>(level.extent[static_cast<std::size_t>(row)]);
    const double reach = radius + 1.42 * extent; // its light may be in a corner
    unseen = chord > std::numbers::sqrt2 + reach;
    if (std::fabs(chord - std::numbers::sqrt2) < reach && extent > at_horizon)
        return false;
    const double distance = std::max(chord - radius - 0.7 * extent, 0.0);
    return extent * extent * fineness2 <= distance * distance + core2;
}

void Walk::visit(std::size_t depth, int column, int row)
{
    const LightCellLevel& level = tree.levels[depth];
    const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(level.width) +
                    static_cast<std::size_t>(column);
    bool unseen = false;
    const bool fine = is_fine(level, at, row, unseen);
    if (unseen)
        return;
    if (fine || depth == 0) {
        cells.x.push_back(level.x[at]), cells.y.push_back(level.y[at]), cells.z.push_back(level.z[at]);
        cells.r.push_back(level.r[at]), cells.g.push_back(level.g[at]), cells.b.push_back(level.b[at]);
        cells.variance.push_back(level.variance[at]);
        return;
    }
    const LightCellLevel& next = tree.levels[depth - 1];
    for (int j = 2 * row; j < std::min(2 * row + 2, next.height); ++j)
        for (int i = 2 * column; i < std::min(2 * column + 2, next.width); ++i)
            visit(depth - 1, i, j);
}

} // namespace

double PrefilterLobe::weight(double cosine) const
{
    if (!(cosine > 0.0))
        return 0.0;
    if (phong)
        return std::pow(cosine, exponent);
    const double q = alpha * alpha + (1.0 - alpha * alpha) * 0.5 * (1.0 - cosine);
    return cosine / (q * q);
}

// GGX: q runs from alpha^2 to (1 + alpha^2) / 2, and cosine / q^2 is a sum of powers of q.
double PrefilterLobe::integral() const
{
    if (phong)
        return 2.0 * std::numbers::pi / (exponent + 1.0);
    const double a2 = alpha * alpha, k = 2.0 / std::max(1.0 - a2, 1e-9);
    if (k > 1e5)
        return std::numbers::pi;
    const double last = 0.5 * (1.0 + a2);
    return 2.0 * std::numbers::pi * k * ((1.0 + a2 * k) * (1.0 / a2 - 1.0 / last) - k * std::log(last / a2));
}

PrefilterLobe ggx_lobe(double alpha)
{
    return {false, 1.0, alpha};
}

PrefilterLobe phong_lobe(double exponent)
{
    return {true, exponent, std::sqrt(2.0 / (exponent + 2.0))};
}

void CellList::clear()
{
    for (auto* column : {&x, &y, &z, &r, &g, &b, &variance})
        column->clear();
}

void prefilter_tile(const LightTree& tree, const PrefilterLobe& lobe, double fineness, CellList& cells,
                    PrefilterTile& tile)
{
    cells.clear();
    Walk walk{tree,
              0.0,
              0.0,
              0.0,
              0.0,
              4.0 * lobe.alpha * lobe.alpha,
              fineness * fineness,
              horizon_extent / lobe.alpha,
              cells};
    for (std::size_t i = 0; i < tile.count; ++i) {
        walk.x += static_cast<double>(tile.x[i]);
        walk.y += static_cast<double>(tile.y[i]);
        walk.z += static_cast<double>(tile.z[i]);
    }
    const double length = std::max(std::hypot(walk.x, walk.y, walk.z), 1e-9);
    walk.x /= length, walk.y /= length, walk.z /= length;
    for (std::size_t i = 0; i < tile.count; ++i)
        walk.radius = std::max(walk.radius, std::hypot(static_cast<double>(tile.x[i]) - walk.x,
                                                       static_cast<double>(tile.y[i]) - walk.y,
                                                       static_cast<double>(tile.z[i]) - walk.z));
    const LightCellLevel& top = tree.levels.back();
    for (int row = 0; row < top.height; ++row)
        for (int column = 0; column < top.width; ++column)
            walk.visit(tree.levels.size() - 1, column, row);
    add_cells(cells, lobe, tile);
}

} // namespace lambent::environment
