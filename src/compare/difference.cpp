#include "compare/difference.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace lambent::compare {
namespace {

// Sums over one or more rows.
struct Sums {
    double squares = 0.0, reference = 0.0, max = 0.0;

    void add(double a, double b)
    {
        const double d = a - b;
        squares += d * d;
        reference += b;
        max = std::max(max, std::fabs(d));
    }
};

Sums joined(const Sums& a, const Sums& b)
{
    return {a.squares + b.squares, a.reference + b.reference, std::max(a.max, b.max)};
}

std::size_t pixels_of(const image::RadianceImage& picture)
{
    return static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
}

void check(const Pair& pair)
{
    if (pair.picture.width != pair.reference.width || pair.picture.height != pair.reference.height)
        throw std::invalid_argument("pictures of different size cannot be compared");
    if (!pair.covered.empty() && pair.covered.size() != pixels_of(pair.picture))
        throw std::invalid_argument("coverage is needed for each pixel");
}

bool counts(const Pair& pair, std::size_t pixel)
{
    return pair.covered.empty() || pair.covered[pixel] != 0;
}

double value_count(const Pair& pair)
{
    return 3.0 * static_cast<double>(pixel_count(pair));
}

Sums sums_of(const Pair& pair)
{
    check(pair);
    const auto add_rows = [&](const tbb::blocked_range<int>& rows, Sums sums) {
        for (int y = rows.begin(); y < rows.end(); ++y)
            for (int x = 0; x < pair.picture.width; ++x)
                if (counts(pair, static_cast<std::size_t>(y) * static_cast<std::size_t>(pair.picture.width) +
                                     static_cast<std::size_t>(x)))
                    for (int c = 0; c < 3; ++c)
                        sums.add(pair.picture.pixel(x, y)[c], pair.reference.pixel(x, y)[c]);
        return sums;
    };
    // Deterministic: the same numbers on any number of threads.
    return tbb::parallel_deterministic_reduce(tbb::blocked_range<int>(0, pair.picture.height, 16), Sums{},
                                              add_rows, joined);
}

float distance(const float* a, const float* b)
{
    double squares = 0.0;
    for (int c = 0; c < 3; ++c)
        squares += (static_cast<double>(a[c]) - b[c]) * (static_cast<double>(a[c]) - b[c]);
    return static_cast<float>(std::sqrt(squares / 3.0));
}

// The map of value(a, b) for each pixel.
template <class Value>
ErrorMap map_of(const Pair& pair, Value&& value)
{
    check(pair);
    const auto width = static_cast<std::size_t>(pair.picture.width);
    ErrorMap map{pair.picture.width, pair.picture.height, {}};
    map.values.resize(width * static_cast<std::size_t>(map.height));
    tbb::parallel_for(0, map.height, [&](int y) {
        for (int x = 0; x < map.width; ++x)
            map.values[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)] =
                value(pair.picture.pixel(x, y), pair.reference.pixel(x, y));
    });
    return map;
}

} // namespace

double mean(const ErrorMap& map)
{
    double sum = 0.0;
    for (const float value : map.values)
        sum += static_cast<double>(value);
    return map.values.empty() ? 0.0 : sum / static_cast<double>(map.values.size());
}

std::size_t pixel_count(const Pair& pair)
{
    return pair.covered.empty()
               ? pixels_of(pair.picture)
               : pair.covered.size() - static_cast<std::size_t>(std::ranges::count(pair.covered, char(0)));
}

double mean(const ErrorMap& map, const Pair& pair)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < map.values.size(); ++i)
        sum += counts(pair, i) ? static_cast<double>(map.values[i]) : 0.0;
    const std::size_t count = pixel_count(pair);
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

Difference difference(const Pair& pair, double peak)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Sums sums = sums_of(pair);
    Difference d;
    d.rmse = std::sqrt(sums.squares / value_count(pair));
    d.max = sums.max;
    d.psnr = d.rmse > 0.0 ? 20.0 * std::log10(peak / d.rmse) : infinity;
    const double mean = sums.reference / value_count(pair);
    d.relative_rmse = d.rmse == 0.0 ? 0.0 : mean > 0.0 ? d.rmse / mean : infinity;
    return d;
}

double largest_value(const image::RadianceImage& picture)
{
    float largest = 0.0f;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            largest =
                std::max({largest, picture.pixel(x, y)[0], picture.pixel(x, y)[1], picture.pixel(x, y)[2]});
    return static_cast<double>(largest);
}

ErrorMap absolute_error(const Pair& pair)
{
    return map_of(pair, distance);
}

ErrorMap relative_error(const Pair& pair)
{
    const double mean = sums_of(pair).reference / value_count(pair);
    const double floor = std::max(0.01 * mean, static_cast<double>(std::numeric_limits<float>::min()));
    return map_of(pair, [floor](const float* a, const float* b) {
        const double light = (static_cast<double>(b[0]) + b[1] + b[2]) / 3.0;
        const double relative = static_cast<double>(distance(a, b)) / (std::max(light, 0.0) + floor);
        return static_cast<float>(std::min(relative, 1e6));
    });
}

RegionError region_error(const Pair& pair, std::span<const int> labels, float limit)
{
    check(pair);
    if (labels.size() != pixels_of(pair.picture))
        throw std::invalid_argument("one label is needed for each pixel");
    struct Region {
        Sums sums;
        double values = 0.0;
    };
    // By label; labels need not be consecutive.
    std::map<int, Region> regions;
    std::size_t i = 0;
    for (int y = 0; y < pair.picture.height; ++y)
        for (int x = 0; x < pair.picture.width; ++x, ++i) {
            if (labels[i] < 0)
                continue;
            Region& region = regions[labels[i]];
            region.values += 3.0;
            for (int c = 0; c < 3; ++c)
                region.sums.add(std::clamp(pair.picture.pixel(x, y)[c], 0.0f, limit),
                                std::clamp(pair.reference.pixel(x, y)[c], 0.0f, limit));
        }
    RegionError error;
    for (const auto& [label, region] : regions) {
        if (!(region.sums.reference > 0.0))
            continue;
        const double relative =
            std::sqrt(region.sums.squares / region.values) / (region.sums.reference / region.values);
        error.mean += relative;
        error.largest = std::max(error.largest, relative);
        ++error.regions;
    }
    error.mean /= std::max(error.regions, 1);
    return error;
}

} // namespace lambent::compare
