// How samples are shared, against trying everything.
#include "reference/samples/budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace lambent::reference {
namespace {

constexpr int step = 8;

// What is left of a tile's variance when it has `samples`.
double variance(const TileState& tile, double samples)
{
    return tile.variance * tile.samples / samples;
}

double cost(const std::vector<TileState>& tiles, const std::vector<int>& samples)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < tiles.size(); ++i)
        sum += variance(tiles[i], samples[i]);
    return sum;
}

// The least sum of variances of all ways to share `total` among three tiles in whole samples, within the bounds.
double best_cost(const std::vector<TileState>& tiles, int total)
{
    const double least = 0.25 * total / 3.0;
    const auto from = [&](std::size_t i) {
        return std::max(tiles[i].samples, static_cast<int>(std::ceil(least)));
    };
    double best = 1e300;
    for (int a = from(0); a <= total; ++a)
        for (int b = from(1); a + b + from(2) <= total; ++b)
            best = std::min(best, cost(tiles, {a, b, total - a - b}));
    return best;
}

TEST(ReferenceBudget, NoOtherWayToShareIsBetter)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform;
    for (int trial = 0; trial < 60; ++trial) {
        std::vector<TileState> tiles;
        int have = 0;
        for (int i = 0; i < 3; ++i) {
            tiles.push_back({step * (2 + static_cast<int>(8.0 * uniform(random))),
                             std::pow(10.0, 4.0 * uniform(random) - 4.0)});
            have += tiles.back().samples;
        }
        const int total = have * 3 / 2;
        const std::vector<int> shared = share_samples(tiles, total, step);
        const int sum = std::accumulate(shared.begin(), shared.end(), 0);
        EXPECT_LE(std::abs(sum - total), 3 * step) << "rounded to steps";
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_GE(shared[i], tiles[i].samples);
            EXPECT_EQ((shared[i] - tiles[i].samples) % step, 0);
            EXPECT_GE(shared[i], 0.25 * total / 3.0 - step);
        }
        // With what it spent, give or take the steps, nothing does better by more than they explain.
        EXPECT_LE(cost(tiles, shared), best_cost(tiles, sum - 3 * step));
        EXPECT_GE(cost(tiles, shared), best_cost(tiles, sum + 3 * step));
    }
}

// Closed form: deviations of one sample 1 and 3, so 1 : 3.
TEST(ReferenceBudget, SamplesGoAsTheDeviation)
{
    const std::vector<TileState> tiles = {{16, 1.0 / 16.0}, {16, 9.0 / 16.0}};
    EXPECT_EQ(share_samples(tiles, 1600.0, step), (std::vector<int>{400, 1200}));
}

TEST(ReferenceBudget, QuietTilesKeepAQuarterOfTheMean)
{
    const std::vector<TileState> tiles = {{16, 0.0}, {16, 1.0}};
    EXPECT_EQ(share_samples(tiles, 1600.0, step), (std::vector<int>{200, 1400}));
}

TEST(ReferenceBudget, NothingToTellThemApart)
{
    const std::vector<TileState> alike(5, TileState{16, 0.3});
    EXPECT_EQ(share_samples(alike, 5 * 64.0, step), std::vector<int>(5, 64));
}

// Where no tile has any variance there is nothing to gain: what tiles have, or the quarter.
TEST(ReferenceBudget, NoVarianceAtAll)
{
    const std::vector<TileState> black(3, TileState{16, 0.0});
    EXPECT_EQ(share_samples(black, 3 * 24.0, step), std::vector<int>(3, 16));
}

// Each once, whatever the picture's shape.
TEST(ReferenceBudget, ScatteredTilesAreAllTiles)
{
    for (const auto& [columns, rows] : {std::pair{1, 1}, {1, 9}, {7, 1}, {2, 2}, {40, 23}, {80, 45}}) {
        std::vector<int> order = scattered_tiles(columns, rows);
        std::sort(order.begin(), order.end());
        std::vector<int> all(static_cast<std::size_t>(columns * rows));
        std::iota(all.begin(), all.end(), 0);
        EXPECT_EQ(order, all) << columns << 'x' << rows;
    }
}

// Of 16 x 8 tiles, the first 2^k: one in each of 2^k equal rectangles, of any shape.
TEST(ReferenceBudget, ScatteredTilesAreSpreadEvenlyFromTheFirst)
{
    const std::vector<int> order = scattered_tiles(16, 8);
    for (int across = 0; across <= 4; ++across)
        for (int down = 0; down <= 3; ++down) {
            std::vector<int> seen(1u << (across + down));
            for (std::size_t i = 0; i < seen.size(); ++i) {
                const int x = order[i] % 16 >> (4 - across), y = order[i] / 16 >> (3 - down);
                ++seen[static_cast<std::size_t>((y << across) + x)];
            }
            EXPECT_EQ(seen, std::vector<int>(seen.size(), 1)) << across << ' ' << down;
        }
}

} // namespace
} // namespace lambent::reference
