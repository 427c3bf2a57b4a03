// The instruments of these tests, tested: quadrature and the chi-square test.
#include "tests/equations/chi_square.h"
#include "tests/equations/quadrature.h"
#include "tests/equations/uniform.h"

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

TEST(ChiSquare, TailHasPublishedQuantiles)
{
    // Abramowitz and Stegun, table 26.8.
    EXPECT_NEAR(chi_square_tail(3.84146, 1), 0.05, 1e-6);
    EXPECT_NEAR(chi_square_tail(18.3070, 10), 0.05, 1e-6);
    EXPECT_NEAR(chi_square_tail(135.807, 100), 0.01, 1e-5);
    EXPECT_NEAR(chi_square_tail(70.0648, 100), 0.99, 1e-5);
}

// Counts of squared uniform numbers, whose density is 1 / (2 sqrt x), with an expectation of x^power.
Cells squares(double power)
{
    Uniform uniform(1);
    constexpr int cells = 50, draws = 100000;
    Cells result = {std::vector<double>(cells), std::vector<double>(cells)};
    for (int i = 0; i < draws; i++) {
        const double x = std::pow(uniform(), 2.0);
        result.counted[static_cast<size_t>(x * cells)]++;
    }
    for (int i = 0; i < cells; i++)
        result.expected[static_cast<size_t>(i)] =
            draws * (std::pow((i + 1.0) / cells, power) - std::pow(i / double(cells), power));
    return result;
}

TEST(ChiSquare, AcceptsTheRightDensity)
{
    EXPECT_GT(chi_square_p(squares(0.5)), false_alarm);
}
TEST(ChiSquare, RefusesAPowerWrongByFivePercent)
{
    EXPECT_LT(chi_square_p(squares(0.525)), false_alarm);
}

TEST(ChiSquare, RefusesADensityThatDoesNotIntegrateToOne)
{
    Cells cells = squares(0.5);
    for (double& e : cells.expected)
        e *= 1.002;
    EXPECT_EQ(chi_square_p(cells), 0.0);
}

TEST(ChiSquare, RefusesCountsWhereNoneAreExpected)
{
    Cells cells = squares(0.5);
    cells.counted.push_back(1.0);
    cells.expected.push_back(0.0);
    EXPECT_EQ(chi_square_p(cells), 0.0);
}

TEST(ChiSquare, PoolsSmallCells)
{
    // One count in a cell that expects 0.01 is no surprise once it is pooled with others.
    const Cells cells = {{1.0, 50.0, 49.0, 0.0}, {0.01, 50.0, 49.5, 0.49}};
    EXPECT_GT(chi_square_p(cells), 0.5);
}

} // namespace
} // namespace lambent::test
