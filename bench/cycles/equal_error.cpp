#include "bench/cycles/equal_error.h"

#include "bench/side_by_side.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace lambent::bench {
namespace {

constexpr std::array<int, 4> sample_counts = {4, 16, 64, 256};
constexpr std::size_t levels = sample_counts.size();

// The mean of independent pictures, and what that is still off in the mean square.
struct Truth {
    std::vector<double> values;
    double mean = 0.0;
    double noise = 0.0;
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
    for (std::size_t i = 0; i < truth.values.size(); ++i) {
        truth.mean += truth.values[i] / size;
        truth.noise += std::max(squares[i] - truth.values[i] * truth.values[i], 0.0) / ((count - 1.0) * size);
    }
    return truth;
}

// Squared relative error.
double error_of(const image::RadianceImage& image, const Truth& truth)
{
    double squares = 0.0;
    for_each_value(image, [&](std::size_t i, double value) {
        squares += (value - truth.values[i]) * (value - truth.values[i]);
    });
    return (squares / static_cast<double>(truth.values.size()) - truth.noise) / (truth.mean * truth.mean);
}

// One program's rounds.
struct Record {
    std::array<std::vector<double>, levels> seconds, cpu_seconds, squared_errors;
    std::vector<double> starts;

    void add(const Series& series, const Truth& truth)
    {
        starts.push_back(series.start_seconds);
        for (std::size_t i = 0; i < levels; ++i) {
            seconds[i].push_back(series.pictures[i].seconds);
            cpu_seconds[i].push_back(series.pictures[i].cpu_seconds);
            squared_errors[i].push_back(error_of(series.pictures[i].radiance, truth));
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

Errors errors_of(const Record& record)
{
    Errors errors;
    for (std::size_t i = 0; i < levels; ++i)
        errors[i] = root_mean(record.squared_errors[i]);
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
        "%s: start of the process %.2f s, of each picture %.2f s; %.2f ms a sample per pixel (CPU %.2f)\n"
        "  relative RMSE",
        name, median(record.starts), wall.start, 1e3 * wall.rate, 1e3 * cpu.rate);
    const Errors errors = errors_of(record);
    for (std::size_t i = 0; i < levels; ++i)
        std::printf("%s %d: %.4f", i == 0 ? "" : ",", sample_counts[i], errors[i]);
    std::puts("");
}

void print_ratios(const Record& ours, const Record& theirs)
{
    const Errors our_errors = errors_of(ours), their_errors = errors_of(theirs);
    const Line our_wall = line_through(ours.seconds), their_wall = line_through(theirs.seconds);
    const Line our_cpu = line_through(ours.cpu_seconds), their_cpu = line_through(theirs.cpu_seconds);
    std::puts("| relative RMSE | Cycles' samples | lambent's | Cycles' sampling | lambent's | ratio | of CPU "
              "time |\n"
              "| --- | --- | --- | --- | --- | --- | --- |");
    for (std::size_t i = 0; i < levels; ++i) {
        const double their_samples = sample_counts[i], our_samples = samples_for(their_errors[i], our_errors);
        std::printf("| %.4f | %.0f | %.1f | %.3f s | %.3f s | %.2f | %.2f |\n", their_errors[i],
                    their_samples, our_samples, their_samples * their_wall.rate, our_samples * our_wall.rate,
                    our_samples * our_wall.rate / (their_samples * their_wall.rate),
                    our_samples * our_cpu.rate / (their_samples * their_cpu.rate));
    }
    std::fflush(stdout);
}

// Seeds that the converged pictures do not have.
std::vector<Order> orders_of(int round)
{
    std::vector<Order> orders;
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
    print_ratios(ours, theirs);
}

} // namespace lambent::bench
