#include "reference/samples/estimate.h"

#include <algorithm>
#include <limits>

namespace lambent::reference {
namespace {

// Input of all formulas: the mean over all samples, and each replicate's mean and share of the samples.
struct Dealt {
    int used = 0;
    double mean = 0.0;
    std::array<double, replicates> means{}, shares{};
};

Dealt dealt(const Sums& sums, int samples)
{
    Dealt d;
    d.used = std::min(samples, replicates);
    for (int r = 0; r < d.used; ++r) {
        const auto i = static_cast<std::size_t>(r);
        const int count = (samples - r + replicates - 1) / replicates;
        const double sum = static_cast<double>(sums[i]);
        d.mean += sum / samples;
        d.means[i] = sum / count;
        d.shares[i] = static_cast<double>(count) / samples;
    }
    return d;
}

// With shares w of the samples and independent means m of variances v, E(m - mean)^2 = v (1 - 2w) + V, where
// V = sum(w^2 v) is the variance of the mean. Weighted by a = w^2 / (1 - 2w), the sum over all replicates is
// V (1 + sum(a)) for all v. (v is not 1 / count of one sample's variance: that of evenly distributed points is less.)
double variance_of(const Dealt& d)
{
    if (d.used == 2) { // both shares are 1/2: this is the limit of the formula
        const double difference = d.means[0] - d.means[1];
        return 0.25 * difference * difference;
    }
    double sum = 0.0, weights = 1.0;
    for (int r = 0; r < d.used; ++r) {
        const auto i = static_cast<std::size_t>(r);
        const double weight = d.shares[i] * d.shares[i] / (1.0 - 2.0 * d.shares[i]);
        sum += weight * (d.means[i] - d.mean) * (d.means[i] - d.mean);
        weights += weight;
    }
    return sum / weights;
}

double jackknife_variance(const Dealt& d, double cut)
{
    const double all = std::min(d.mean, cut);
    std::array<double, replicates> without{};
    double center = d.used * all;
    for (int r = 0; r < d.used; ++r) {
        const auto i = static_cast<std::size_t>(r);
        const double w = d.shares[i];
        without[i] = std::min((d.mean - w * d.means[i]) / (1.0 - w), cut);
        center -= (1.0 - w) * without[i];
    }
    double sum = 0.0;
    for (int r = 0; r < d.used; ++r) {
        const auto i = static_cast<std::size_t>(r);
        const double groups = 1.0 / d.shares[i];
        const double difference = groups * all - (groups - 1.0) * without[i] - center;
        sum += difference * difference / (groups - 1.0);
    }
    return sum / d.used;
}

} // namespace

Estimate estimate(const Sums& sums, int samples, double cut)
{
    const Dealt d = dealt(sums, samples);
    Estimate e;
    e.mean = d.mean;
    e.cut_mean = std::min(d.mean, cut);
    if (d.used < 2) {
        e.variance = e.cut_error = std::numeric_limits<double>::infinity();
        return e;
    }
    e.variance = variance_of(d);
    e.cut_error = d.mean < cut ? e.variance : jackknife_variance(d, cut);
    return e;
}

} // namespace lambent::reference
