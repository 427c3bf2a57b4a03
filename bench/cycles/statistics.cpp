#include "bench/cycles/statistics.h"

#include <cmath>
#include <limits>

namespace lambent::bench {

Measured measured(const std::vector<double>& values)
{
    const auto count = static_cast<double>(values.size());
    Measured m;
    for (const double value : values)
        m.mean += value / count;
    for (const double value : values)
        m.variance += (value - m.mean) * (value - m.mean) / ((count - 1.0) * count);
    return m;
}

double standardised(const Measured& a, const Measured& b)
{
    const double difference = a.mean - b.mean, variance = a.variance + b.variance;
    if (difference == 0.0)
        return 0.0;
    return variance > 0.0 ? difference / std::sqrt(variance) : std::numeric_limits<double>::infinity();
}

std::vector<double> values_at(std::span<const Taken> pictures, std::size_t pixel)
{
    std::vector<double> values;
    for (const Taken& picture : pictures) {
        const auto channels = static_cast<std::size_t>(picture.radiance.channels);
        const float* rgb = picture.radiance.values.data() + pixel * channels;
        values.push_back(
            (static_cast<double>(rgb[0]) + static_cast<double>(rgb[1]) + static_cast<double>(rgb[2])) / 3.0);
    }
    return values;
}

std::vector<double> values_over(std::span<const Taken> pictures, const std::vector<std::size_t>& pixels)
{
    std::vector<double> means(pictures.size());
    for (const std::size_t pixel : pixels) {
        const std::vector<double> values = values_at(pictures, pixel);
        for (std::size_t i = 0; i < values.size(); ++i)
            means[i] += values[i] / static_cast<double>(pixels.size());
    }
    return means;
}

} // namespace lambent::bench
