// Pearson's chi-square test: are these counts what the density says? [Pearson 1900]
#pragma once

#include <vector>

namespace lambent::test {

// Probability that a chi-square variable of so many degrees of freedom exceeds the statistic.
double chi_square_tail(double statistic, int degrees);

// Counts per cell, and what a density expects there.
struct Cells {
    std::vector<double> counted;
    std::vector<double> expected;
};

// The p-value: the probability of counts at least this far from what is expected, if the density is right.
// Cells that expect fewer than 5 are pooled, least first, so that the chi-square law holds. The density must
// integrate to 1 over the cells (within 0.1%): otherwise, and for counts where nothing is expected, the
// p-value is 0.
double chi_square_p(const Cells& cells);

// A test fails where the p-value is below this: one correct sampler in 10,000, for random seeds. Seeds are
// fixed, so a test that passes keeps passing.
constexpr double false_alarm = 1e-4;

} // namespace lambent::test
