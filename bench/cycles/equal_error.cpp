#include "bench/cycles/equal_error.h"

#include "bench/side_by_side.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace lambent::bench {
namespace {

constexpr std::array<int, 4> sample_counts = {4, 16, 64, 256};
constexpr std::size_t levels = sample_counts.size();

// A few pixels that see a lamp by two mirrors outweigh all others in a mean square; cut, they count as displayed.
constexpr std::array<double, 2> limits = {1.0, std::numeric_limits<double>::infinity()};

// The mean of independent pictures, and what that is still off in the mean square of values cut at a limit.
struct Truth {
    std::vector<double> values;
    std::array<double, limits.size()> means{}, noises{};
};

// Each channel of each pixel; alpha, where there is one, is left out.
template <class Visit>
void for_each_value(const image::RadianceImage& image, Visit&& visit)
{
    const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
        for (std::size_t channel = 0; channel < 3; ++channel)
            visit(3 * pixel + channel, static_cast<double>(image.values[pixel * channels + channel]));
}

Truth truth_of(const std::vector<Taken>& pictures)
{
    const auto count = static_cast<double>(pictures.size());
    Truth truth;
    std::vector<double> squares;
    for (const Taken& picture : pictures) {
        truth.values.resize(3 * picture.radiance.values.size() /
                            static_cast<std::size_t>(picture.radiance.channels));
        squares.resize(truth.values.size());
        for_each_value(picture.radiance, [&](std::size_t i, double value) {
            truth.values[i] += value / count;
            squares[i] += value * value / count;
        });
    }
    const auto size = static_cast<double>(truth.values.size());
    for (std::size_t i = 0; i < truth.values.size(); ++i)
        for (std::size_t k = 0; k < limits.size(); ++k) {
            const double variance =
                std::max(squares[i] - truth.values[i] * truth.values[i], 0.0) / (count - 1.0);
            truth.means[k] += std::min(truth.values[i], limits[k]) / size;
            truth.noises[k] += truth.values[i] < limits[k] ? variance / size : 0.0;
        }
    return truth;
}

// Squared relative error.
double error_of(const image::RadianceImage& image, const Truth& truth, std::size_t k)
{
    double squares = 0.0;
    for_each_value(image, [&](std::size_t i, double value) {
        const double off = std::min(value, limits[k]) - std::min(truth.values[i], limits[k]);
        squares += off * off;
    });
    return (squares / static_cast<double>(truth.values.size()) - truth.noises[k]) /
           (truth.means[k] * truth.means[k]);
}

// One program's rounds.
struct Record {
    std::array<std::vector<double>, levels> seconds, cpu_seconds;
    std::array<std::array<std::vector<double>, levels>, limits.size()>
        squared_errors; ///< by limit, level, round
    std::vector<double> starts;

    void add(const Series& series, const Truth& truth)
    {
        starts.push_back(series.start_seconds);
        for (std::size_t i = 0; i < levels; ++i) {
            seconds[i].push_back(series.pictures[i].seconds);
            cpu_seconds[i].push_back(series.pictures[i].cpu_seconds);
            for (std::size_t k = 0; k < limits.size(); ++k)
                squared_errors[k][i].push_back(error_of(series.pictures[i].radiance, truth, k));
        }
    }
};

// Time is start + rate * samples; the start (building the tree, reading back) is no sampling.
struct Line {
    double start, rate;
};

Line line_through(const std::array<std::vector<double>, levels>& seconds)
{
    const double first = median(seconds.front()), last = median(seconds.back());
    const double rate = (last - first) / (sample_counts.back() - sample_counts.front());
    return {first - rate * sample_counts.front(), rate};
}

double root_mean(const std::vector<double>& squares)
{
    double sum = 0.0;
    for (const double square : squares)
        sum += square;
    return std::sqrt(std::max(sum, 0.0) / static_cast<double>(squares.size()));
}

using Errors = std::array<double, levels>;

Errors errors_of(const Record& record, std::size_t k)
{
    Errors errors;
    for (std::size_t i = 0; i < levels; ++i)
        errors[i] = root_mean(record.squared_errors[k][i]);
    return errors;
}

// Samples at which the error is reached: straight between (and beyond) the measured ones, in logarithms.
double samples_for(double error, const Errors& errors)
{
    std::size_t i = 0;
    while (i + 2 < levels && errors[i + 1] > error)
        ++i;
    const double share = std::log(errors[i] / error) / std::log(errors[i] / errors[i + 1]);
    return sample_counts[i] * std::pow(static_cast<double>(sample_counts[i + 1]) / sample_counts[i], share);
}

void print_program(const char* name, const Record& record)
{
    const Line wall = line_through(record.seconds), cpu = line_through(record.cpu_seconds);
    std::printf(
        "%s: start of the process %.2f s, of each picture %.2f s; %.2f ms a sample per pixel (CPU %.2f)\n",
        name, median(record.starts), wall.start, 1e3 * wall.rate, 1e3 * cpu.rate);
}

void print_ratios(const Record& ours, const Record& theirs, std::size_t k)
{
    const Errors our_errors = errors_of(ours, k), their_errors = errors_of(theirs, k);
    const double our_rate = line_through(ours.seconds).rate, their_rate = line_through(theirs.seconds).rate;
    const double our_cpu = line_through(ours.cpu_seconds).rate;
    const double their_cpu = line_through(theirs.cpu_seconds).rate;
    std::printf(
        "values cut at %g\n| samples | Cycles' relative RMSE | lambent's | lambent's samples to Cycles' "
        "error | Cycles' sampling | lambent's | ratio | of CPU time |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- |\n",
        limits[k]);
    for (std::size_t i = 0; i < levels; ++i) {
        const double samples = samples_for(their_errors[i], our_errors), share = samples / sample_counts[i];
        std::printf("| %d | %.4f | %.4f | %.1f | %.3f s | %.3f s | %.2f | %.2f |\n", sample_counts[i],
                    their_errors[i], our_errors[i], samples, sample_counts[i] * their_rate,
                    samples * our_rate, share * our_rate / their_rate, share * our_cpu / their_cpu);
    }
    std::fflush(stdout);
}

// Seeds that the converged pictures do not have.
std::vector<Order> orders_of(int round)
{
    std::vector<Order> orders;
    orders.reserve(std::size(sample_counts));
    for (const int count : sample_counts)
        orders.push_back({count, static_cast<std::uint32_t>(1000 + round)});
    return orders;
}

} // namespace

void print_time_to_equal_error(const Programs& programs, const SamePictures& converged, int rounds)
{
    const Truth our_truth = truth_of(converged.lambent), their_truth = truth_of(converged.cycles);
    Record ours, theirs;
    for (int round = 0; round < rounds; ++round) {
        ours.add(programs.lambent(orders_of(round)), our_truth);
        theirs.add(programs.cycles(orders_of(round)), their_truth);
    }
    print_program("lambent", ours);
    print_program("Cycles", theirs);
    for (std::size_t k = 0; k < limits.size(); ++k)
        print_ratios(ours, theirs, k);
}

} // namespace lambent::bench
