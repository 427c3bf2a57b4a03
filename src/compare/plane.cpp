#include "compare/plane.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace lambent::compare {
namespace {

void filter_row(const float* from, int width, const Kernel& kernel, std::vector<float>& padded, float* to)
{
    const int radius = static_cast<int>(kernel.size() / 2);
    padded.resize(static_cast<std::size_t>(width + 2 * radius));
    std::fill_n(padded.begin(), radius, from[0]);
    std::copy_n(from, width, padded.begin() + radius);
    std::fill_n(padded.begin() + radius + width, radius, from[width - 1]);
    std::fill_n(to, width, 0.0f);
    for (std::size_t i = 0; i < kernel.size(); ++i) {
        const float weight = kernel[i];
        const float* in = padded.data() + i;
        for (int x = 0; x < width; ++x)
            to[x] += weight * in[x];
    }
}

} // namespace

Plane filtered(const Plane& plane, const Kernel& across, const Kernel& down)
{
    Plane rows(plane.width, plane.height), result(plane.width, plane.height);
    tbb::parallel_for(tbb::blocked_range<int>(0, plane.height), [&](const tbb::blocked_range<int>& range) {
        std::vector<float> padded;
        for (int y = range.begin(); y < range.end(); ++y)
            filter_row(plane.row(y), plane.width, across, padded, rows.row(y));
    });
    const int radius = static_cast<int>(down.size() / 2);
    tbb::parallel_for(0, plane.height, [&](int y) {
        float* const to = result.row(y);
        for (int i = -radius; i <= radius; ++i) {
            const float weight = down[static_cast<std::size_t>(i + radius)];
            const float* from = rows.row(std::clamp(y + i, 0, plane.height - 1));
            for (int x = 0; x < plane.width; ++x)
                to[x] += weight * from[x];
        }
    });
    return result;
}

} // namespace lambent::compare
