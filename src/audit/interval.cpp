#include "audit/interval.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace lambent::audit {
namespace {

constexpr int resamples = 2000;

// No less than this share of the variance is left after the correction for few pixels, which is itself noisy.
constexpr double least_variance = 0.1;

// The observations times their weights, less the mean of all.
struct Sample {
    std::vector<Moments> centred;
    Moments mean;
    double light = 0.0; ///< of the picture

    Sample(const std::vector<Observation>& observations, double picture_light) : light(picture_light)
    {
        const auto count = static_cast<double>(observations.size());
        for (const Observation& o : observations) {
            centred.push_back({o.weight * o.moments.square, o.weight * o.moments.difference});
            mean.square += centred.back().square;
            mean.difference += centred.back().difference;
        }
        mean = {mean.square / count, mean.difference / count};
        for (Moments& m : centred)
            m = {m.square - mean.square, m.difference - mean.difference};
    }
};

// mean square / (mean light)^2. The mean light is that of the picture, which is known, plus the mean difference.
struct Ratio {
    Moments mean;
    double light = 0.0, value = 0.0, variance = 0.0;

    // The linearised ratio, of moments less their means.
    double influence(const Moments& centred) const
    {
        return centred.square / (light * light) -
               2.0 * mean.square * centred.difference / (light * light * light);
    }
};

// Of as many observations as the sample has; index() gives the next.
template <class Index>
Ratio ratio_of(const Sample& sample, Index&& index)
{
    Moments sum;
    double squares = 0.0, products = 0.0, differences = 0.0;
    for (std::size_t i = 0; i < sample.centred.size(); ++i) {
        const Moments& m = sample.centred[index()];
        sum.square += m.square;
        sum.difference += m.difference;
        squares += m.square * m.square;
        products += m.square * m.difference;
        differences += m.difference * m.difference;
    }
    const auto n = static_cast<double>(sample.centred.size());
    const Moments off{sum.square / n, sum.difference / n};
    Ratio r;
    r.mean = {sample.mean.square + off.square, sample.mean.difference + off.difference};
    r.light = sample.light + r.mean.difference;
    r.value = r.mean.square / (r.light * r.light);
    // The variance of influence(), whose coefficients these are.
    const double a = 1.0 / (r.light * r.light), b = -2.0 * r.mean.square * a / r.light;
    r.variance = (a * a * (squares - n * off.square * off.square) +
                  2.0 * a * b * (products - n * off.square * off.difference) +
                  b * b * (differences - n * off.difference * off.difference)) /
                 (n * (n - 1.0));
    return r;
}

// Observations drawn without replacement from a population of N vary less than independent ones, by the variance of the
// pixels themselves over N. [Cochran 1977, "Sampling techniques", section 2.6] The product of two independent halves is
// the square of a pixel's influence without that of its noise.
double corrected_variance(const Ratio& ratio, const std::vector<Observation>& observations,
                          std::size_t population)
{
    double spread = 0.0;
    const auto centred = [&](const Moments& m) {
        return Moments{m.square - ratio.mean.square, m.difference - ratio.mean.difference};
    };
    for (const Observation& o : observations)
        spread += o.weight * ratio.influence(centred(o.half[0])) * ratio.influence(centred(o.half[1]));
    spread /= static_cast<double>(observations.size());
    return std::clamp(ratio.variance - spread / static_cast<double>(population),
                      least_variance * ratio.variance, ratio.variance);
}

// Of (ratio of a resample - ratio) / standard deviation of a resample, in ascending order.
std::vector<double> studentised(const Sample& sample, double value, std::uint32_t seed)
{
    std::mt19937 random(seed);
    const std::uint64_t count = sample.centred.size();
    std::vector<double> deviations;
    deviations.reserve(resamples);
    for (int b = 0; b < resamples; ++b) {
        const Ratio again =
            ratio_of(sample, [&] { return static_cast<std::size_t>(random() * count >> 32); });
        const double t = (again.value - value) / std::sqrt(again.variance);
        if (std::isfinite(t))
            deviations.push_back(t);
    }
    std::sort(deviations.begin(), deviations.end());
    return deviations;
}

// The value below which this share of sorted values lies.
double quantile(const std::vector<double>& sorted, double share)
{
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

double root(double square)
{
    return std::sqrt(std::max(square, 0.0));
}

} // namespace

Error error_of(const std::vector<Observation>& observations, const Population& population)
{
    const Sample sample(observations, population.light);
    const Ratio ratio = ratio_of(sample, [i = std::size_t{0}]() mutable { return i++; });
    Error error;
    error.pixels = static_cast<int>(observations.size());
    error.relative_mse = ratio.value;
    error.relative_rmse = root(ratio.value);
    if (!(ratio.light > 0.0)) {
        error.high = std::numeric_limits<double>::infinity();
        return error;
    }
    error.low = error.high = error.relative_rmse;
    const std::vector<double> t = studentised(sample, ratio.value, population.seed);
    if (t.empty())
        return error; // all observations are alike
    const double deviation = std::sqrt(corrected_variance(ratio, observations, population.pixels));
    const double outside = (1.0 - error.confidence) / 2.0;
    error.low = root(ratio.value - std::max(quantile(t, 1.0 - outside), 0.0) * deviation);
    // A negative estimate is that of an error that noise hides, 0 or little more.
    error.high = root(std::max(ratio.value, 0.0) - std::min(quantile(t, outside), 0.0) * deviation);
    return error;
}

} // namespace lambent::audit
