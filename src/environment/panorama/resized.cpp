#include "environment/panorama/resized.h"

#include "image/panorama_lookup.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::environment {
namespace {

// Shares of consecutive source rows or columns, from `first` on, in one row or column of the result; they add up to 1.
struct PixelShares {
    int first = 0;
    std::vector<double> of;

    void add(int index, double share)
    {
        if (of.empty())
            first = index;
        of.resize(std::max(of.size(), static_cast<std::size_t>(index - first) + 1));
        of[static_cast<std::size_t>(index - first)] += share;
    }
};

// The integral over [top, bottom] of the sine times a row's weight, which is linear from 0 at `start` to 1 at `end`.
double rising(double start, double end, double top, double bottom)
{
    const auto primitive = [start](double a) { return std::sin(a) - (a - start) * std::cos(a); };
    return (primitive(bottom) - primitive(top)) / (end - start);
}

// The shares of the source rows, whose polar angles are `angles`, in a row from `top` to `bottom`. Rows -1 and the
// number of rows are those beyond the poles.
PixelShares row_shares(const std::vector<double>& angles, double top, double bottom)
{
    const int last = static_cast<int>(angles.size()) - 1;
    const auto above = std::upper_bound(angles.begin(), angles.end(), top);
    const double whole = std::cos(top) - std::cos(bottom);
    PixelShares shares;
    for (int next = static_cast<int>(above - angles.begin()); next <= last + 1; ++next) {
        const double start = next > 0 ? angles[static_cast<std::size_t>(next) - 1] : -angles.front();
        const double end =
            next <= last ? angles[static_cast<std::size_t>(next)] : 2.0 * std::numbers::pi - angles.back();
        const double from = std::max(start, top), to = std::min(end, bottom);
        if (from >= to)
            break;
        const double area = (std::cos(from) - std::cos(to)) / whole;
        const double lower = rising(start, end, from, to) / whole;
        shares.add(next - 1, area - lower);
        shares.add(next, lower);
    }
    return shares;
}

// The shares of the source columns in a column from `left` to `right`, in units of source columns, whose centres are at
// 1/2, 3/2, ... Columns -1 and the number of columns wrap around.
PixelShares column_shares(double left, double right)
{
    PixelShares shares;
    for (int start = static_cast<int>(std::floor(left - 0.5)); start + 0.5 < right; ++start) {
        const double from = std::max(left - 0.5 - start, 0.0), to = std::min(right - 0.5 - start, 1.0);
        if (from >= to)
            continue;
        const double lower = 0.5 * (to * to - from * from) / (right - left);
        shares.add(start, (to - from) / (right - left) - lower);
        shares.add(start + 1, lower);
    }
    return shares;
}

std::vector<PixelShares> all_column_shares(int from, int to)
{
    std::vector<PixelShares> all;
    const double step = static_cast<double>(from) / to;
    for (int x = 0; x < to; ++x)
        all.push_back(column_shares(x * step, (x + 1) * step));
    return all;
}

// The mean of source rows by their shares, RGB.
std::vector<double> mixed_row(const Panorama& from, const PixelShares& shares)
{
    std::vector<double> row(3 * static_cast<std::size_t>(from.width));
    for (std::size_t i = 0; i < shares.of.size(); ++i)
        for (int x = 0; x < from.width; ++x) {
            const image::PanoramaTexel at =
                image::texel_across(x, shares.first + static_cast<int>(i), from.width, from.height);
            const Rgb c = from.radiance(at.x, at.y);
            double* const out = row.data() + 3 * static_cast<std::size_t>(x);
            out[0] += shares.of[i] * static_cast<double>(c.r);
            out[1] += shares.of[i] * static_cast<double>(c.g);
            out[2] += shares.of[i] * static_cast<double>(c.b);
        }
    return row;
}

} // namespace

Panorama resized(const Panorama& from, int width, int height)
{
    image::RadianceImage image = image::black_image(width, height);
    const std::vector<double> angles = image::row_angles(from.height);
    const std::vector<PixelShares> columns = all_column_shares(from.width, width);
    const double step = std::numbers::pi / height;
    tbb::parallel_for(0, height, [&](int y) {
        const std::vector<double> row = mixed_row(from, row_shares(angles, y * step, (y + 1) * step));
        for (int x = 0; x < width; ++x) {
            const PixelShares& shares = columns[static_cast<std::size_t>(x)];
            double sum[3] = {};
            for (std::size_t i = 0; i < shares.of.size(); ++i) {
                const int column = (shares.first + static_cast<int>(i) + from.width) % from.width;
                for (std::size_t k = 0; k < 3; ++k)
                    sum[k] += shares.of[i] * row[3 * static_cast<std::size_t>(column) + k];
            }
            for (std::size_t k = 0; k < 3; ++k)
                image.pixel(x, y)[k] = static_cast<float>(sum[k]);
        }
    });
    return make_panorama(image);
}

Panorama at_least(const Panorama& panorama, int width, int height)
{
    if (panorama.width >= width && panorama.height >= height)
        return panorama;
    return resized(panorama, std::max(panorama.width, width), std::max(panorama.height, height));
}

} // namespace lambent::environment
