#include "denoise/statistical_filter.h"

#include "base/error.h"
#include "denoise/statistical_planes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace lambent::denoise {
namespace {

void check_size(const Plane& plane, std::size_t size, const char* name)
{
    if (plane.size() != size)
        throw Error(Failure::usage, std::string("denoise: ") + name + " has " + std::to_string(plane.size()) +
                                        " values, the picture " + std::to_string(size) + " pixels");
}

std::size_t check(const NoisyPicture& picture)
{
    if (picture.width < 0 || picture.height < 0)
        throw Error(Failure::usage, "denoise: the picture's size is negative");
    const std::size_t size =
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    for (std::size_t c = 0; c < 3; ++c) {
        check_size(picture.light[c], size, "the light");
        check_size(picture.variance[c], size, "the variance");
        check_size(picture.emitted[c], size, "the emitted light");
        check_size(picture.albedo[c], size, "the albedo");
        check_size(picture.normal[c], size, "the normal");
    }
    check_size(picture.freedom, size, "the degrees of freedom");
    check_size(picture.coverage, size, "the coverage");
    check_size(picture.depth, size, "the depth");
    return size;
}

Averages average(const StatisticalPlanes& planes)
{
    const int width = planes.width(), height = planes.height();
    const std::size_t size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    Averages averages{{Plane(size), Plane(size), Plane(size)}, Plane(size)};
    constexpr int most_columns = FilterTile::most_columns, most_rows = FilterTile::most_rows;
    const int across = (width + most_columns - 1) / most_columns, down = (height + most_rows - 1) / most_rows;
    tbb::parallel_for(0, across * down, [&](int i) {
        const int x = i % across * most_columns, y = i / across * most_rows;
        average_tile(planes, {x, y, std::min(most_columns, width - x), std::min(most_rows, height - y)},
                     averages);
    });
    return averages;
}

// Squared distance of the filtered light from the unfiltered over the latter's variance, mean of the channels, less what
// noise alone explains: (1 - w)^2 if the average of many pixels of equal means gives the pixel itself the weight w.
float excess(const StatisticalPlanes& planes, const Averages& averages, int x, int y)
{
    constexpr float most = 10.0f; // noise is not normal
    const std::size_t i =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(planes.width()) + static_cast<std::size_t>(x);
    float sum = 0.0f;
    for (int c = 0; c < 3; ++c) {
        const float off =
            averages.light[static_cast<std::size_t>(c)][i] - *planes.at(reflected_plane + c, x, y);
        sum += std::min(off * off / *planes.at(variance_plane + c, x, y), most);
    }
    const float others = 1.0f - averages.own_share[i];
    const float per_variance = 1.0f - 2.0f * *planes.at(inverse_plane, x, y); // one over the mean of t^2
    return per_variance * sum / 3.0f - others * others;
}

// Where filtered light is further from the unfiltered than noise explains, the filter is wrong by the rest: both are
// mixed with the shares that make the squared error least. [shrinkage: James and Stein 1961; Lee 1980]
class Shrinkage {
public:
    Shrinkage(const StatisticalPlanes& planes, const Averages& averages)
        : width_(planes.width()), height_(planes.height()), excess_(averages.own_share.size()),
          usable_(excess_.size())
    {
        tbb::parallel_for(0, height_, [&](int y) {
            for (int x = 0; x < width_; ++x)
                if (*planes.at(usable_plane, x, y) > 0.0f) {
                    usable_[index(x, y)] = 1.0f;
                    excess_[index(x, y)] = excess(planes, averages, x, y);
                }
        });
    }

    /// Share of the unfiltered light at a pixel, in [0, 1], by the 5 x 5 pixels around.
    float unfiltered(int x, int y) const
    {
        constexpr int reach = 2;
        float sum = 0.0f, count = 0.0f;
        for (int j = std::max(y - reach, 0); j <= std::min(y + reach, height_ - 1); ++j)
            for (int i = std::max(x - reach, 0); i <= std::min(x + reach, width_ - 1); ++i) {
                sum += excess_[index(i, j)];
                count += usable_[index(i, j)];
            }
        const float bias = count > 0.0f ? std::max(sum / count, 0.0f) : 0.0f; // squared, over the variance
        return bias / (bias + 1.0f);
    }

private:
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    int width_, height_;
    Plane excess_, usable_;
};

} // namespace

Rgb filter_statistically(const NoisyPicture& picture)
{
    const std::size_t size = check(picture);
    Rgb result{Plane(size), Plane(size), Plane(size)};
    if (size == 0)
        return result;
    StatisticalPlanes planes(picture.width, picture.height);
    fill(picture, planes);
    tbb::parallel_for(0, picture.height, [&](int y) { pool_variance(planes, y); });
    const Averages averages = average(planes);
    const Shrinkage shrinkage(planes, averages);
    tbb::parallel_for(0, picture.height, [&](int y) {
        for (int x = 0; x < picture.width; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                  static_cast<std::size_t>(x);
            const bool usable = *planes.at(usable_plane, x, y) > 0.0f;
            const float unfiltered = usable ? shrinkage.unfiltered(x, y) : 1.0f;
            for (int c = 0; c < 3; ++c) {
                const auto channel = static_cast<std::size_t>(c);
                const float given = picture.light[channel][i];
                const float light = unfiltered * *planes.at(reflected_plane + c, x, y) +
                                    (1.0f - unfiltered) * averages.light[channel][i];
                result[channel][i] =
                    usable
                        ? std::max(picture.emitted[channel][i] + *planes.at(albedo_plane + c, x, y) * light,
                                   0.0f)
                    : std::isfinite(given) ? given
                                           : 0.0f;
            }
        }
    });
    return result;
}

} // namespace lambent::denoise
