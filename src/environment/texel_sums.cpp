#include "environment/prefilter.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <cmath>
#include <numbers>

namespace lambent::environment {
namespace {

class TexelRows {
public:
    explicit TexelRows(const Panorama& panorama)
        : panorama_(panorama), count_((static_cast<std::size_t>(panorama.width) + 7) / 8 * 8)
    {
        for (std::size_t x = 0; x < count_; ++x) {
            const double phi =
                ((static_cast<double>(x) + 0.5) / panorama.width - 0.5) * 2.0 * std::numbers::pi;
            x_.push_back(std::cos(phi));
            z_.push_back(std::sin(phi));
        }
    }

    void add(int y, std::vector<double>& light, std::vector<TexelSum>& sums) const
    {
        light.assign(3 * count_, 0.0);
        for (int x = 0; x < panorama_.width; ++x) {
            const Rgb c = panorama_.radiance(x, y);
            const auto at = static_cast<std::size_t>(x);
            light[at] = static_cast<double>(c.r);
            light[count_ + at] = static_cast<double>(c.g);
            light[2 * count_ + at] = static_cast<double>(c.b);
        }
        const double theta = (y + 0.5) / panorama_.height * std::numbers::pi;
        const TexelRow row{x_.data(),
                           z_.data(),
                           light.data(),
                           light.data() + count_,
                           light.data() + 2 * count_,
                           std::cos(theta),
                           std::sin(theta),
                           texel_solid_angle(panorama_, y),
                           count_};
        for (TexelSum& sum : sums)
            add_texel_row(row, sum);
    }

private:
    const Panorama& panorama_;
    std::size_t count_;
    std::vector<double> x_, z_;
};

} // namespace

void sum_texels(const Panorama& panorama, std::span<TexelSum> sums)
{
    std::vector<TexelSum> none(sums.begin(), sums.end());
    for (TexelSum& sum : none)
        sum.rgb[0] = sum.rgb[1] = sum.rgb[2] = 0.0;
    const TexelRows rows(panorama);
    const auto add = [&](const tbb::blocked_range<int>& range, std::vector<TexelSum> total) {
        std::vector<double> light;
        for (int y = range.begin(); y < range.end(); ++y)
            rows.add(y, light, total);
        return total;
    };
    const auto join = [](std::vector<TexelSum> a, const std::vector<TexelSum>& b) {
        for (std::size_t i = 0; i < a.size(); ++i)
            for (int k = 0; k < 3; ++k)
                a[i].rgb[k] += b[i].rgb[k];
        return a;
    };
    const std::vector<TexelSum> all =
        tbb::parallel_reduce(tbb::blocked_range<int>(0, panorama.height, 32), none, add, join);
    for (std::size_t i = 0; i < sums.size(); ++i)
        for (int k = 0; k < 3; ++k)
            sums[i].rgb[k] = all[i].rgb[k] / sums[i].lobe.integral();
}

} // namespace lambent::environment
