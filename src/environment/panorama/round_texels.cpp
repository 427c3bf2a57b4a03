#include "environment/panorama/round_texels.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambent::environment {
namespace {

// Sets each texel of a row to the mean of itself and `half` texels on either side.
void average(const Panorama& from, int y, int half, Panorama& to)
{
    const auto width = static_cast<std::size_t>(from.width);
    const auto column = [&](int x) { return ((x % from.width) + from.width) % from.width; };
    double sum[3] = {};
    const auto add = [&](int x, double sign) {
        const Rgb c = unpack_rgb9e5(
            from.texels[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(column(x))]);
        sum[0] += sign * static_cast<double>(c.r), sum[1] += sign * static_cast<double>(c.g);
        sum[2] += sign * static_cast<double>(c.b);
    };
    for (int x = -half; x <= half; ++x)
        add(x, 1.0);
    const double share = 1.0 / (2 * half + 1);
    for (int x = 0; x < from.width; ++x) {
        float rgb[3];
        for (int k = 0; k < 3; ++k)
            rgb[k] = static_cast<float>(std::max(sum[k] * share, 0.0)); // subtraction leaves rounding errors
        to.texels[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)] =
            pack_rgb9e5(rgb[0], rgb[1], rgb[2]);
        add(x - half, -1.0);
        add(x + half + 1, 1.0);
    }
}

} // namespace

Panorama with_round_texels(const Panorama& panorama)
{
    Panorama result = panorama;
    tbb::parallel_for(0, panorama.height, [&](int y) {
        const double sine = std::sin((y + 0.5) / panorama.height * std::numbers::pi);
        const double columns = panorama.width / (2.0 * panorama.height * sine); // together as wide as high
        const int half =
            std::min(static_cast<int>(std::lround(0.5 * (columns - 1.0))), (panorama.width - 1) / 2);
        if (half > 0)
            average(panorama, y, half, result);
    });
    return result;
}

} // namespace lambent::environment
