#include "denoise/statistical_planes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace lambent::denoise {
namespace {

// Larger values, or such that are not finite, are no light; of variances the square. What the filter makes of the rest
// stays finite.
constexpr float most_light = 1.0e12f, most_albedo = 1.0e3f;

// Light is divided by no lesser albedo: such a pixel says little of the light that arrives.
constexpr float least_albedo = 1.0e-3f, least_coverage = 1.0e-3f;

template <std::size_t count>
bool are_within(const std::array<Plane, count>& planes, std::size_t i, float most)
{
    return std::all_of(planes.begin(), planes.end(),
                       [&](const Plane& plane) { return std::fabs(plane[i]) <= most; });
}

bool is_usable(const NoisyPicture& p, std::size_t i)
{
    const bool is_known = p.freedom[i] > 0.0f;
    return are_within(p.light, i, most_light) && are_within(p.emitted, i, most_light) &&
           are_within(p.albedo, i, most_albedo) && are_within(p.normal, i, 2.0f) &&
           std::fabs(p.depth[i]) <= most_light && p.coverage[i] > 0.0f &&
           (!is_known || are_within(p.variance, i, most_light * most_light)) &&
           std::max({p.albedo[0][i], p.albedo[1][i], p.albedo[2][i]}) > 0.0f;
}

void fill_pixel(const NoisyPicture& p, int x, int y, StatisticalPlanes& to)
{
    const std::size_t i =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(p.width) + static_cast<std::size_t>(x);
    if (!is_usable(p, i))
        return;
    *to.at(usable_plane, x, y) = 1.0f;
    *to.at(freedom_plane, x, y) = p.freedom[i] > 0.0f ? std::min(p.freedom[i], 1.0e6f) : 0.0f;
    *to.at(coverage_plane, x, y) = std::clamp(p.coverage[i], least_coverage, 1.0f);
    *to.at(surface_plane + surface_depth, x, y) = std::max(p.depth[i], 0.0f);
    for (int c = 0; c < 3; ++c) {
        const auto channel = static_cast<std::size_t>(c);
        const float albedo = std::max(p.albedo[channel][i], least_albedo);
        *to.at(albedo_plane + c, x, y) = albedo;
        *to.at(reflected_plane + c, x, y) = (p.light[channel][i] - p.emitted[channel][i]) / albedo;
        *to.at(own_variance_plane + c, x, y) =
            p.freedom[i] > 0.0f ? std::max(p.variance[channel][i], 0.0f) / (albedo * albedo) : 0.0f;
        *to.at(surface_plane + c, x, y) = p.normal[channel][i];
    }
}

// Depth's lesser difference to the neighbours on both sides, which does not reach over an edge; 0 without any.
float slope(const StatisticalPlanes& p, int x, int y, std::ptrdiff_t step)
{
    const float* const depth = p.at(surface_plane + surface_depth, x, y);
    const float* const usable = p.at(usable_plane, x, y);
    const float back = *depth - depth[-step], ahead = depth[step] - *depth;
    const bool has_back = usable[-step] > 0.0f, has_ahead = usable[step] > 0.0f;
    if (!has_back || !has_ahead)
        return has_back ? back : has_ahead ? ahead : 0.0f;
    return std::fabs(back) < std::fabs(ahead) ? back : ahead;
}

} // namespace

// To the right, kernels read and write whole vectors.
StatisticalPlanes::StatisticalPlanes(int width, int height)
    : width_(width), height_(height), pitch_(width + 2 * margin + 16), rows_(height + 2 * margin),
      values_(static_cast<std::size_t>(statistical_planes * pitch_ * rows_))
{
    const auto plane = [&](int which) { return values_.begin() + which * pitch_ * rows_; };
    std::fill(plane(variance_plane), plane(variance_plane + 3), 1.0f);
}

void fill(const NoisyPicture& picture, StatisticalPlanes& planes)
{
    tbb::parallel_for(0, picture.height, [&](int y) {
        for (int x = 0; x < picture.width; ++x)
            fill_pixel(picture, x, y, planes);
    });
    tbb::parallel_for(0, picture.height, [&](int y) {
        for (int x = 0; x < picture.width; ++x) {
            if (!(*planes.at(usable_plane, x, y) > 0.0f))
                continue;
            *planes.at(surface_plane + surface_slope_x, x, y) = slope(planes, x, y, 1);
            *planes.at(surface_plane + surface_slope_y, x, y) = slope(planes, x, y, planes.pitch());
        }
    });
}

} // namespace lambent::denoise
