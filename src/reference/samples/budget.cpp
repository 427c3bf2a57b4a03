#include "reference/samples/budget.h"

#include "reference/samples/sampler.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lambent::reference {

std::vector<int> share_samples(std::span<const TileState> tiles, double total, int step)
{
    std::vector<double> deviation, least;
    double largest = 0.0;
    for (const TileState& tile : tiles) {
        deviation.push_back(std::sqrt(tile.variance * tile.samples));
        least.push_back(
            std::max(static_cast<double>(tile.samples), 0.25 * total / static_cast<double>(tiles.size())));
        largest = std::max(largest, deviation.back());
    }
    const auto wanted = [&](std::size_t i, double scale) { return std::max(least[i], scale * deviation[i]); };
    const auto sum = [&](double scale) {
        double all = 0.0;
        for (std::size_t i = 0; i < tiles.size(); ++i)
            all += wanted(i, scale);
        return all;
    };
    // The sum grows with the scale, which bisection therefore finds.
    double low = 0.0, high = largest > 0.0 ? 2.0 * total / largest : 0.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (sum(middle) < total ? low : high) = middle;
    }
    std::vector<int> samples;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const int more = std::max(static_cast<int>(std::lround(wanted(i, low))) - tiles[i].samples, 0);
        samples.push_back(tiles[i].samples + (more + step / 2) / step * step);
    }
    return samples;
}

// Of the first 2^(a + b) Sobol points, one lies in each cell of a grid of 2^a x 2^b.
std::vector<int> scattered_tiles(int columns, int rows)
{
    const int across = std::bit_width(static_cast<std::uint32_t>(columns - 1)),
              down = std::bit_width(static_cast<std::uint32_t>(rows - 1));
    const auto cell = [](std::uint32_t fraction, int bits) {
        return static_cast<int>(std::uint64_t{fraction} >> (32 - bits));
    };
    std::vector<int> order;
    order.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (std::uint32_t i = 0; i < 1u << (across + down); ++i) {
        const std::array<std::uint32_t, 4> point = sobol(i);
        const int x = cell(point[0], across), y = cell(point[1], down);
        if (x < columns && y < rows)
            order.push_back(y * columns + x);
    }
    return order;
}

} // namespace lambent::reference
