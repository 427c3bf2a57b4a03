// The instruments of the tests, tested: quadrature and the chi-square test.
#include "tests/equations/quadrature.h"
#include "tests/equations/uniform.h"
#include "tests/support/chi_square.h"

#include <gtest/gtest.h>

namespace lambent::test {
namespace {

TEST(Quadrature, KnownIntegrals)
{
    EXPECT_NEAR(integrate([](double x) { return std::exp(x); }, 0.0, 1.0), std::numbers::e - 1.0, 1e-12);
    EXPECT_NEAR(integrate([](double x) { return std::sqrt(x); }, 0.0, 1.0), 2.0 / 3.0, 1e-8);
    const auto peak = [](double x) { return 1e-3 / ((x - 0.3) * (x - 0.3) + 1e-6); };
    EXPECT_NEAR(integrate(peak, -1.0, 1.0, 1e-9, 64), std::atan(700.0) + std::atan(1300.0), 1e-8);
    EXPECT_NEAR(integrate_about_pole([](double c) { return c; }), pi, 1e-9);
    EXPECT_NEAR(integrate_sphere([](double x, double, double) { return x * x; }), 4.0 * pi / 3.0, 1e-12);
}

constexpr std::size_t cells = 50;

// Squared uniform numbers, whose density is 1 / (2 sqrt x).
std::vector<double> squares()
{
    Uniform uniform(1);
    return count(100000, cells, [&] { return part_of(std::pow(uniform(), 2.0), cells); });
}

// The probabilities of cells where x^power is the distribution.
std::vector<double> powers(double power)
{
    std::vector<double> probabilities;
    for (std::size_t i = 0; i < cells; i++) {
        const double low = static_cast<double>(i) / cells, high = static_cast<double>(i + 1) / cells;
        probabilities.push_back(std::pow(high, power) - std::pow(low, power));
    }
    return probabilities;
}

TEST(ChiSquare, AcceptsTheRightDensity)
{
    EXPECT_TRUE(follows(squares(), powers(0.5)));
}

TEST(ChiSquare, RefusesAPowerWrongByFivePercent)
{
    EXPECT_FALSE(follows(squares(), powers(0.525)));
}

TEST(ChiSquare, RefusesADensityThatDoesNotIntegrateToOne)
{
    std::vector<double> probabilities = powers(0.5);
    for (double& p : probabilities)
        p *= 1.002;
    EXPECT_FALSE(follows(squares(), probabilities));
}

TEST(ChiSquare, RefusesCountsWhereNoneAreExpected)
{
    std::vector<double> counts = squares(), probabilities = powers(0.5);
    counts.push_back(1.0);
    probabilities.push_back(0.0);
    EXPECT_FALSE(follows(counts, probabilities));
}

TEST(ChiSquare, PoolsSmallCells)
{
    // One count in a cell that expects 0.01 is no surprise once it is pooled with others.
    EXPECT_TRUE(follows({1.0, 50.0, 49.0, 0.0}, {0.0001, 0.5, 0.495, 0.0049}));
}

// One time in 10,000 a right sampler is refused: 18.42 of two degrees of freedom. [exp(-x / 2) = 1e-4]
TEST(ChiSquare, RefusesBeyondItsQuantile)
{
    const auto counts = [](double off) { return std::vector<double>{1e6 + off, 1e6 - off, 1e6}; };
    EXPECT_TRUE(follows_evenly(counts(std::sqrt(0.5e6 * 18.41))));
    EXPECT_FALSE(follows_evenly(counts(std::sqrt(0.5e6 * 18.43))));
}

TEST(ChiSquare, PartsOfAnInterval)
{
    EXPECT_EQ(part_of(0.0, 4), 0U);
    EXPECT_EQ(part_of(0.26, 4), 1U);
    EXPECT_EQ(part_of(1.0, 4), 3U);
    EXPECT_EQ(part_of(-1e-9, 4), 0U);
    EXPECT_EQ(part_of_turn(-0.1, 4), 3U);
    EXPECT_EQ(part_of_turn(0.1 + 4.0 * pi, 4), 0U);
}

} // namespace
} // namespace lambent::test
