// Pearson's chi-square test: do draws follow a density? [Pearson 1900] One line for each use:
//     EXPECT_TRUE(follows(count(draws, cells, [&] { return cell_of(draw()); }), probabilities));
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace lambent::test {

/// A test fails this often, for random seeds, where the sampler is right: one time in 10,000. Seeds are fixed, so a test that
/// passes keeps passing.
constexpr double false_alarm = 1e-4;

/// Of n equal parts of [0, 1] that which x is in; the first or last beyond them.
std::size_t part_of(double x, std::size_t n);

/// Of n equal parts of a turn that which an angle in radians is in, whichever turn it is.
std::size_t part_of_turn(double angle, std::size_t n);

/// How often draw() gives each of so many cells.
template <class Draw>
std::vector<double> count(int draws, std::size_t cells, const Draw& draw)
{
    std::vector<double> counts(cells);
    for (int i = 0; i < draws; ++i)
        ++counts.at(draw());
    return counts;
}

/// Whether the counts are what the probabilities of the cells say. Cells that expect fewer than 5 are pooled, the least likely
/// first, so that the chi-square law holds. Probabilities that do not add up to 1 (within 0.1 %), and counts where nothing is
/// expected, are refused.
testing::AssertionResult follows(const std::vector<double>& counts, const std::vector<double>& probabilities);

/// The same for cells that are all as likely.
testing::AssertionResult follows_evenly(const std::vector<double>& counts);

} // namespace lambent::test
