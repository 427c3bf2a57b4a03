#include "draw/light/sample_plan.h"

#include <algorithm>
#include <cmath>

namespace lambent::draw {
namespace {

// Samples of a pixel in a planned pass, on average. They cost more than those everywhere: they go to what mirrors other
// things, where rays go on. With so many a pass takes as long as the first.
constexpr double of_planned_pass = 1.4;

// The least deviation of a square, in that of the mean one: errors are estimated from few samples, and what they have
// missed must come.
constexpr double least_deviation = 0.3;

} // namespace

SamplePlan::SamplePlan(int width, int height)
    : columns_((width + side - 1) / side), rows_((height + side - 1) / side),
      wanted_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), of_pass),
      taken_(wanted_.size(), 0)
{
}

void SamplePlan::end_pass()
{
    for (std::size_t i = 0; i < wanted_.size(); ++i)
        taken_[i] += wanted_[i];
}

// Standard deviation of one sample of a pixel, from the error that is left of those taken; pooled over 3x3 squares.
std::vector<double> SamplePlan::deviations(const std::vector<Square>& squares) const
{
    std::vector<double> deviations(squares.size(), 0.0);
    double sum = 0.0, all = 0.0;
    for (int row = 0; row < rows_; ++row)
        for (int column = 0; column < columns_; ++column) {
            double variance = 0.0, covered = 0.0;
            for (int j = std::max(row - 1, 0); j <= std::min(row + 1, rows_ - 1); ++j)
                for (int i = std::max(column - 1, 0); i <= std::min(column + 1, columns_ - 1); ++i) {
                    const auto at = static_cast<std::size_t>(j * columns_ + i);
                    const double weight = (i == column ? 2.0 : 1.0) * (j == row ? 2.0 : 1.0);
                    variance += weight * squares[at].error * taken_[at];
                    covered += weight * squares[at].covered;
                }
            const auto at = static_cast<std::size_t>(row * columns_ + column);
            if (!(squares[at].covered > 0.0))
                continue;
            deviations[at] = std::sqrt(std::max(variance, 0.0) / covered);
            sum += deviations[at] * squares[at].covered;
            all += squares[at].covered;
        }
    for (std::size_t i = 0; i < squares.size(); ++i)
        if (squares[i].covered > 0.0)
            deviations[i] = std::max(deviations[i], least_deviation * sum / all);
    return deviations;
}

// Samples of a pixel that lead from those taken to `samples` in all. Pairs are rounded up or down from square to square, so
// that equal squares get what they should in the mean: by a sequence that fills planes evenly [Roberts 2018, "The
// unreasonable effectiveness of quasirandom sequences"].
std::uint32_t SamplePlan::wanted_with(double samples, std::size_t square) const
{
    const double column = static_cast<double>(square % static_cast<std::size_t>(columns_)),
                 row = static_cast<double>(square / static_cast<std::size_t>(columns_));
    const double place = 0.7548776662466927 * column + 0.5698402909980532 * row;
    const double pairs = std::floor(0.5 * (samples - taken_[square]) + place - std::floor(place));
    return 2 * static_cast<std::uint32_t>(std::clamp(pairs, 0.0, at_most / 2.0));
}

void SamplePlan::plan(const std::vector<Square>& squares)
{
    const std::vector<double> deviation = deviations(squares);
    const auto cost_with = [&](double scale) {
        double cost = 0.0;
        for (std::size_t i = 0; i < squares.size(); ++i)
            cost += squares[i].covered * wanted_with(scale * deviation[i], i);
        return cost;
    };
    double budget = 0.0, least = 0.0;
    for (std::size_t i = 0; i < squares.size(); ++i) {
        budget += of_planned_pass * squares[i].covered;
        if (deviation[i] > 0.0)
            least = least > 0.0 ? std::min(least, deviation[i]) : deviation[i];
    }
    std::fill(wanted_.begin(), wanted_.end(), of_pass);
    if (!(least > 0.0))
        return;
    // The scale that spends the budget, by bisection; the upper end is what nobody needs.
    double low = 0.0, high = (*std::max_element(taken_.begin(), taken_.end()) + at_most) / least;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (cost_with(middle) <= budget ? low : high) = middle;
    }
    for (std::size_t i = 0; i < squares.size(); ++i)
        wanted_[i] = wanted_with(low * deviation[i], i);
}

} // namespace lambent::draw
