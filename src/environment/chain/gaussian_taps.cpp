#include "environment/chain/gaussian_taps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

namespace lambent::environment {
namespace {

// Radii of rings of equal weight, in standard deviations: those whose mean spectrum, of Bessel functions J0, is nearest
// to the Gaussian's, within 0.01, up to three over its deviation.
constexpr double four_rings[] = {0.567, 1.130, 1.130, 2.264};
constexpr double five_rings[] = {0.247, 1.201, 1.201, 1.201, 2.368};

} // namespace

GaussianTaps gaussian_taps(int rings, float deviation)
{
    constexpr int around = GaussianTaps::around;
    const std::span<const double> radii = rings == 4 ? std::span<const double>(four_rings) : five_rings;
    double mean_square = 0.0;
    for (const double radius : radii)
        mean_square += radius * radius / static_cast<double>(radii.size());
    const double scale = deviation * std::sqrt(2.0 / mean_square);
    GaussianTaps taps;
    for (std::size_t ring = 0; ring < radii.size(); ++ring) {
        const double angle = std::min(radii[ring] * scale, std::numbers::pi);
        for (int i = 0; i < around; ++i) {
            const double phi = 2.0 * std::numbers::pi / around * (i + 0.5 * static_cast<double>(ring % 2));
            taps.x.push_back(static_cast<float>(std::sin(angle) * std::cos(phi)));
            taps.y.push_back(static_cast<float>(std::sin(angle) * std::sin(phi)));
            taps.z.push_back(static_cast<float>(std::cos(angle)));
        }
    }
    return taps;
}

} // namespace lambent::environment
