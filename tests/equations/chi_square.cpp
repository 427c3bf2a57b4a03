#include "tests/equations/chi_square.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lambent::test {
namespace {

// Lower regularised incomplete gamma function by its power series, for x < a + 1.
double gamma_series(double a, double x)
{
    double term = 1.0 / a, sum = term;
    for (int n = 1; n < 10000 && term > sum * 1e-16; n++) {
        term *= x / (a + n);
        sum += term;
    }
    return sum * std::exp(a * std::log(x) - x - std::lgamma(a));
}

// Upper regularised incomplete gamma function by its continued fraction (Lentz's method), for x >= a + 1.
double gamma_fraction(double a, double x)
{
    double b = x + 1.0 - a, c = 1e300, d = 1.0 / b, h = d;
    for (int n = 1; n < 10000; n++) {
        const double an = -n * (n - a);
        b += 2.0;
        d = 1.0 / (an * d + b);
        c = b + an / c;
        h *= c * d;
        if (std::abs(c * d - 1.0) < 1e-15)
            break;
    }
    return h * std::exp(a * std::log(x) - x - std::lgamma(a));
}

// Cells in ascending order of what they expect, gathered until each group expects at least 5.
Cells pooled(const Cells& cells)
{
    std::vector<size_t> order(cells.expected.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::sort(order.begin(), order.end(),
              [&](size_t a, size_t b) { return cells.expected[a] < cells.expected[b]; });
    Cells groups;
    bool open = false;
    for (size_t cell : order) {
        if (!open) {
            groups.counted.push_back(0.0);
            groups.expected.push_back(0.0);
        }
        groups.counted.back() += cells.counted[cell];
        groups.expected.back() += cells.expected[cell];
        open = groups.expected.back() < 5.0;
    }
    return groups;
}

bool counted_where_none_is_expected(const Cells& cells)
{
    for (size_t i = 0; i < cells.expected.size(); i++)
        if (!(cells.expected[i] > 0.0) && cells.counted[i] > 0.0)
            return true;
    return false;
}

} // namespace

double chi_square_tail(double statistic, int degrees)
{
    const double a = 0.5 * degrees, x = 0.5 * statistic;
    if (x <= 0.0)
        return 1.0;
    return x < a + 1.0 ? 1.0 - gamma_series(a, x) : gamma_fraction(a, x);
}

double chi_square_p(const Cells& cells)
{
    const double counted = std::accumulate(cells.counted.begin(), cells.counted.end(), 0.0);
    const double expected = std::accumulate(cells.expected.begin(), cells.expected.end(), 0.0);
    if (!(std::abs(expected / counted - 1.0) < 1e-3) || counted_where_none_is_expected(cells))
        return 0.0;
    const Cells groups = pooled(cells);
    double statistic = 0.0;
    for (size_t i = 0; i < groups.expected.size(); i++) {
        const double difference = groups.counted[i] - groups.expected[i];
        statistic += difference * difference / groups.expected[i];
    }
    return chi_square_tail(statistic, static_cast<int>(groups.expected.size()) - 1);
}

} // namespace lambent::test
