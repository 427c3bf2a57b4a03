#include "environment/bake/texel_sums.h"

#include "environment/bake/light_points.h"
#include "environment/bake/sum_rows.h"
#include "image/panorama_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::environment {
namespace {

// Panoramas of more than this many columns are summed in blocks, each at the centroid of its light, except near narrow
// lobes, texel by texel. The error of blocks is of second order: less than 0.1 % for lobes of this alpha.
constexpr int most_blocks = 1024;
constexpr double least_alpha_of_blocks = 0.12;
constexpr double near_in_alphas = 12.0;

struct Angles {
    double theta, phi, cosine, sine; // polar angle and azimuth; cosine and sine of the polar angle
};

Angles angles_of(const TexelSum& sum)
{
    const double theta = std::acos(std::clamp(sum.y, -1.0, 1.0));
    return {theta, std::atan2(sum.z, sum.x), std::cos(theta), std::sin(theta)};
}

class BlockRows {
public:
    explicit BlockRows(const Panorama& panorama)
        : panorama_(panorama), side_((panorama.width + most_blocks - 1) / most_blocks),
          columns_((panorama.width + side_ - 1) / side_)
    {
        for (int x = 0; x < panorama.width; ++x) {
            const double phi = image::column_azimuth(x + 0.5, panorama.width);
            cosine_.push_back(std::cos(phi));
            sine_.push_back(std::sin(phi));
        }
    }

    int count() const { return (panorama_.height + side_ - 1) / side_; }

    // The buffers of one thread.
    struct Work {
        std::vector<LightPoints> texels; // row by row
        LightPoints blocks;
    };

    void add(int row, Work& work, std::vector<TexelSum>& sums) const
    {
        const int first = row * side_, last = std::min(first + side_, panorama_.height);
        work.texels.resize(static_cast<std::size_t>(last - first));
        for (int y = first; y < last; ++y)
            load(y, work.texels[static_cast<std::size_t>(y - first)]);
        if (side_ > 1)
            gather(work);
        for (TexelSum& sum : sums) {
            if (side_ == 1)
                add_points(work.texels[0], {0, static_cast<std::size_t>(panorama_.width)}, sum);
            else
                add_near_and_far(row, work, sum);
        }
    }

private:
    void load(int y, LightPoints& points) const
    {
        const double theta = (y + 0.5) / panorama_.height * std::numbers::pi;
        const double up = std::cos(theta), ring = std::sin(theta), area = texel_solid_angle(panorama_, y);
        points.resize(static_cast<std::size_t>(panorama_.width));
        for (int x = 0; x < panorama_.width; ++x) {
            const Rgb c = panorama_.radiance(x, y);
            const auto at = static_cast<std::size_t>(x);
            points.x[at] = ring * cosine_[at], points.y[at] = up, points.z[at] = ring * sine_[at];
            points.r[at] = area * static_cast<double>(c.r);
            points.g[at] = area * static_cast<double>(c.g);
            points.b[at] = area * static_cast<double>(c.b);
        }
    }

    void gather(Work& work) const
    {
        work.blocks.resize(0);
        work.blocks.resize(static_cast<std::size_t>(columns_));
        LightPoints& to = work.blocks;
        std::vector<double> weights(static_cast<std::size_t>(columns_));
        for (const LightPoints& from : work.texels)
            for (int x = 0; x < panorama_.width; ++x) {
                const auto i = static_cast<std::size_t>(x), at = static_cast<std::size_t>(x / side_);
                const double w = from.r[i] + from.g[i] + from.b[i] + 1e-30;
                to.x[at] += w * from.x[i], to.y[at] += w * from.y[i], to.z[at] += w * from.z[i];
                to.r[at] += from.r[i], to.g[at] += from.g[i], to.b[at] += from.b[i];
                weights[at] += w;
            }
        for (std::size_t i = 0; i < weights.size(); ++i)
            to.x[i] /= weights[i], to.y[i] /= weights[i], to.z[i] /= weights[i];
    }

    // The number of blocks to either side of a direction's azimuth that are near it; 0: none.
    double near_columns(int row, const TexelSum& sum, const Angles& at) const
    {
        if (sum.lobe.alpha >= least_alpha_of_blocks)
            return 0.0;
        const double step = std::numbers::pi / panorama_.height * side_;
        const double theta = (row + 0.5) * step, reach = near_in_alphas * sum.lobe.alpha + step;
        if (std::fabs(theta - at.theta) > reach)
            return 0.0;
        const double rings = std::sin(theta) * at.sine;
        const double cosine = (std::cos(reach) - std::cos(theta) * at.cosine) / std::max(rings, 1e-9);
        const double turn = std::acos(std::clamp(cosine, -1.0, 1.0));
        return turn / (2.0 * std::numbers::pi) * columns_ + 1.0;
    }

    void add_near_and_far(int row, const Work& work, TexelSum& sum) const
    {
        const Angles at = angles_of(sum);
        const double half = near_columns(row, sum, at);
        const double middle = (at.phi / (2.0 * std::numbers::pi) + 0.5) * columns_;
        const int first = static_cast<int>(std::floor(middle - half)),
                  last = static_cast<int>(std::ceil(middle + half));
        if (half > 0.0 && last - first >= columns_)
            add_part(work, 0, columns_, true, sum);
        else if (!(half > 0.0))
            add_part(work, 0, columns_, false, sum);
        else if (first < 0 || last > columns_) {
            const int low = first < 0 ? last : last - columns_, high = first < 0 ? first + columns_ : first;
            add_part(work, 0, low, true, sum);
            add_part(work, low, high, false, sum);
            add_part(work, high, columns_, true, sum);
        } else {
            add_part(work, 0, first, false, sum);
            add_part(work, first, last, true, sum);
            add_part(work, last, columns_, false, sum);
        }
    }

    // Adds blocks [first, last), or their texels.
    void add_part(const Work& work, int first, int last, bool texels, TexelSum& sum) const
    {
        if (first >= last)
            return;
        if (!texels) {
            add_points(work.blocks, {static_cast<std::size_t>(first), static_cast<std::size_t>(last)}, sum);
            return;
        }
        const int end = std::min(last * side_, panorama_.width);
        for (const LightPoints& row : work.texels)
            add_points(row, {static_cast<std::size_t>(first * side_), static_cast<std::size_t>(end)}, sum);
    }

    const Panorama& panorama_;
    int side_, columns_;
    std::vector<double> cosine_, sine_;
};

} // namespace

void LightPoints::resize(std::size_t count)
{
    for (std::vector<double>* column : {&x, &y, &z, &r, &g, &b})
        column->resize(count > 0 ? count + 8 : 0);
}

void sum_texels(const Panorama& panorama, std::span<TexelSum> sums)
{
    const BlockRows rows(panorama);
    sum_rows<BlockRows::Work>(
        rows.count(),
        [&](int row, BlockRows::Work& work, std::vector<TexelSum>& total) { rows.add(row, work, total); },
        sums);
}

} // namespace lambent::environment
