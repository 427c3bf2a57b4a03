#include "tests/support/chi_square.h"

#include <boost/math/distributions/chi_squared.hpp>

#include <algorithm>
#include <numbers>
#include <numeric>

namespace lambent::test {
namespace {

struct Group {
    double counted = 0.0, expected = 0.0;
};

// Cells in ascending order of what they expect, gathered until each group expects at least 5.
std::vector<Group> pooled(const std::vector<double>& counts, const std::vector<double>& probabilities)
{
    const double draws = std::accumulate(counts.begin(), counts.end(), 0.0);
    std::vector<std::size_t> order(counts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return probabilities[a] < probabilities[b]; });
    std::vector<Group> groups;
    for (const std::size_t cell : order) {
        if (groups.empty() || groups.back().expected >= 5.0)
            groups.emplace_back();
        groups.back().counted += counts[cell];
        groups.back().expected += draws * probabilities[cell];
    }
    return groups;
}

} // namespace

std::size_t part_of(double x, std::size_t n)
{
    return std::min(static_cast<std::size_t>(std::max(x, 0.0) * static_cast<double>(n)), n - 1);
}

std::size_t part_of_turn(double angle, std::size_t n)
{
    const double turns = angle / (2.0 * std::numbers::pi);
    return part_of(turns - std::floor(turns), n);
}

testing::AssertionResult follows(const std::vector<double>& counts, const std::vector<double>& probabilities)
{
    if (counts.size() != probabilities.size())
        return testing::AssertionFailure()
               << counts.size() << " cells have " << probabilities.size() << " probabilities";
    const double whole = std::accumulate(probabilities.begin(), probabilities.end(), 0.0);
    if (!(std::abs(whole - 1.0) < 1e-3))
        return testing::AssertionFailure() << "the probabilities add up to " << whole;
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (!(probabilities[i] > 0.0) && counts[i] > 0.0)
            return testing::AssertionFailure() << "cell " << i << " was drawn, though its probability is 0";
    const std::vector<Group> groups = pooled(counts, probabilities);
    if (groups.size() < 2)
        return testing::AssertionFailure() << "there is no choice between " << counts.size() << " cells";
    double statistic = 0.0;
    for (const Group& group : groups)
        statistic += (group.counted - group.expected) * (group.counted - group.expected) / group.expected;
    const boost::math::chi_squared law(static_cast<double>(groups.size() - 1));
    const double most = boost::math::quantile(boost::math::complement(law, false_alarm));
    return (statistic <= most ? testing::AssertionSuccess() : testing::AssertionFailure())
           << "chi-square is " << statistic << ", up to " << most << " is usual for " << groups.size()
           << " groups of cells";
}

testing::AssertionResult follows_evenly(const std::vector<double>& counts)
{
    return follows(counts, std::vector<double>(counts.size(), 1.0 / static_cast<double>(counts.size())));
}

} // namespace lambent::test
