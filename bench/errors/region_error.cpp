#include "bench/errors/region_error.h"

#include <algorithm>
#include <cmath>

namespace lambent::bench {
namespace {

struct Sums {
    double squares = 0.0, light = 0.0;
    int values = 0;

    void add(double value, double first, double second)
    {
        squares += (value - first) * (value - second);
        light += 0.5 * (first + second);
        ++values;
    }
};

double cut(float value, float limit)
{
    return static_cast<double>(std::min(value, limit));
}

} // namespace

RegionError region_error(const image::RadianceImage& picture, const ReferencePair& reference,
                         const Regions& regions, float limit)
{
    std::vector<Sums> sums;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const int region = regions[static_cast<std::size_t>(y * picture.width + x)];
            if (region < 0)
                continue;
            if (static_cast<std::size_t>(region) >= sums.size())
                sums.resize(static_cast<std::size_t>(region) + 1);
            for (int c = 0; c < 3; ++c)
                sums[static_cast<std::size_t>(region)].add(cut(picture.pixel(x, y)[c], limit),
                                                           cut(reference.first->pixel(x, y)[c], limit),
                                                           cut(reference.second->pixel(x, y)[c], limit));
        }
    RegionError error;
    int regions_seen = 0;
    for (const Sums& s : sums)
        if (s.values > 0 && s.light > 0.0) {
            const double relative = std::sqrt(std::max(s.squares / s.values, 0.0)) / (s.light / s.values);
            error.mean += relative;
            error.largest = std::max(error.largest, relative);
            ++regions_seen;
        }
    error.mean /= std::max(regions_seen, 1);
    return error;
}

} // namespace lambent::bench
