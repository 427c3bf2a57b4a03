#include "bench/errors/region_error.h"

#include <algorithm>
#include <cmath>

namespace lambent::bench {
namespace {

// Of the values of a pixel, which are not independent.
struct Sums {
    double squares = 0.0, light = 0.0;
    double spread = 0.0; // of the squares of pixels
    int pixels = 0;

    void add(double product, double mean)
    {
        squares += product;
        light += mean;
        spread += product * product;
        ++pixels;
    }

    double mean_square() const { return squares / pixels; }
    double standard_error() const
    {
        return std::sqrt(std::max(spread / pixels - mean_square() * mean_square(), 0.0) / pixels);
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
            double product = 0.0, light = 0.0;
            for (int c = 0; c < 3; ++c) {
                const double value = cut(picture.pixel(x, y)[c], limit),
                             first = cut(reference.first->pixel(x, y)[c], limit),
                             second = cut(reference.second->pixel(x, y)[c], limit);
                product += (value - first) * (value - second) / 3.0;
                light += 0.5 * (first + second) / 3.0;
            }
            sums[static_cast<std::size_t>(region)].add(product, light);
        }
    RegionError error;
    int regions_seen = 0;
    double low = 0.0;
    for (const Sums& s : sums)
        if (s.pixels > 0 && s.light > 0.0) {
            const auto relative = [&](double errors) {
                return std::sqrt(std::max(s.mean_square() + errors * s.standard_error(), 0.0)) /
                       (s.light / s.pixels);
            };
            error.mean += relative(0.0);
            error.most += relative(2.0);
            error.largest = std::max(error.largest, relative(0.0));
            low += relative(-2.0);
            ++regions_seen;
        }
    error.mean /= std::max(regions_seen, 1);
    error.most /= std::max(regions_seen, 1);
    error.resolved = low > 0.0;
    return error;
}

} // namespace lambent::bench
