#include "environment/sky/sky_table.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::environment {
namespace {

Rgb weighted(float weight, const Rgb& c)
{
    return {weight * c.r, weight * c.g, weight * c.b};
}

Rgb sum(const Rgb& a, const Rgb& b)
{
    return {a.r + b.r, a.g + b.g, a.b + b.b};
}

SkyLight plus(const SkyLight& a, float weight, const SkyLight& b)
{
    return {sum(a.air, weighted(weight, b.air)), sum(a.haze, weighted(weight, b.haze)),
            sum(a.even, weighted(weight, b.even))};
}

// Weights of four values in equal steps at the fraction t between the second and the third. [Catmull and Rom 1974]
std::array<float, 4> cubic_weights(float t)
{
    const float t2 = t * t, t3 = t2 * t;
    return {0.5f * (-t3 + 2.0f * t2 - t), 0.5f * (3.0f * t3 - 5.0f * t2 + 2.0f),
            0.5f * (-3.0f * t3 + 4.0f * t2 + t), 0.5f * (t3 - t2)};
}

} // namespace

SkyTable::SkyTable(const ClearSky& sky, const SkyTableSize& size)
    : size_(size), edge_(sky.ground_edge()),
      lights_(2 * static_cast<std::size_t>(size.elevations) * static_cast<std::size_t>(size.angles))
{
    tbb::parallel_for(0, 2 * size_.elevations, [&](int i) {
        const double elevation = node_elevation(i % size_.elevations, i >= size_.elevations);
        for (int j = 0; j < size_.angles; ++j)
            lights_[static_cast<std::size_t>(i * size_.angles + j)] =
                sky.light(elevation, j * std::numbers::pi / (size_.angles - 1));
    });
}

// Steps grow evenly from the ground's edge up and down.
double SkyTable::node_elevation(int i, bool ground) const
{
    constexpr double just_below = 1e-9;
    const double t = static_cast<double>(i) / (size_.elevations - 1);
    const double quarter = 0.5 * std::numbers::pi;
    return ground ? edge_ - just_below - t * t * (quarter + edge_ - just_below)
                  : edge_ + t * t * (quarter - edge_);
}

SkyTable::Row SkyTable::row(double elevation) const
{
    const bool ground = elevation < edge_;
    const double quarter = 0.5 * std::numbers::pi;
    const double t =
        ground ? (edge_ - elevation) / (quarter + edge_) : (elevation - edge_) / (quarter - edge_);
    const int last = size_.elevations - 1;
    const double position = std::sqrt(std::clamp(t, 0.0, 1.0)) * last;
    const int first = std::min(static_cast<int>(position), last - 1);
    const std::array<float, 4> weights = cubic_weights(static_cast<float>(position - first));
    Row row(static_cast<std::size_t>(size_.angles));
    for (int k = 0; k < 4; ++k) {
        const int i = std::clamp(first + k - 1, 0, last) + (ground ? size_.elevations : 0);
        const SkyLight* node = lights_.data() + i * size_.angles;
        for (std::size_t j = 0; j < row.size(); ++j)
            row[j] = plus(row[j], weights[static_cast<std::size_t>(k)], node[j]);
    }
    return row;
}

SkyLight between(const SkyTable::Row& row, int angle, float fraction)
{
    const std::size_t i = static_cast<std::size_t>(angle);
    return plus(plus({}, 1.0f - fraction, row[i]), fraction, row[i + 1]);
}

} // namespace lambent::environment
