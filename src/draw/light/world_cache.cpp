#include "draw/light/world_cache.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lambent::draw {
namespace {

// Light of other surfaces can exceed the unshadowed light; by more than this it is kept as an amount, not as a ratio.
constexpr double most_ratio = 4.0;

} // namespace

WorldCache::WorldCache(std::shared_ptr<const CacheCells> cells, float unit)
    : cells_(std::move(cells)), sums_(cells_->size()),
      scale_(0x1p22 / static_cast<double>(std::max(unit, 1e-30f)))
{
}

void WorldCache::add(Sums& sums, const CachedLight& light) const
{
    const auto fixed = [&](float value) {
        const double scaled = static_cast<double>(value) * scale_;
        return static_cast<std::int64_t>(std::isfinite(scaled) ? std::clamp(scaled, -0x1p44, 0x1p44) : 0.0);
    };
    for (std::size_t k = 0; k < light_classes; ++k)
        for (std::size_t c = 0; c < 3; ++c) {
            const int channel = static_cast<int>(c);
            sums.light[0][k][c].fetch_add(fixed(light.unshadowed[k][channel]), std::memory_order_relaxed);
            sums.light[1][k][c].fetch_add(fixed(light.found[k][channel]), std::memory_order_relaxed);
        }
    sums.points.fetch_add(1, std::memory_order_relaxed);
}

void WorldCache::add(const CacheCells::Membership& of, const CachedLight& light)
{
    for (const std::uint32_t cell : of)
        if (cell != CacheCells::none)
            add(sums_[cell], light);
}

std::array<glm::vec3, light_classes>
WorldCache::true_light(std::uint32_t speaker, const std::array<glm::vec3, light_classes>& light) const
{
    if (speaker == CacheCells::none)
        return light;
    const Sums& sums = sums_[speaker];
    const double points = static_cast<double>(sums.points.load(std::memory_order_relaxed));
    std::array<glm::vec3, light_classes> result{};
    for (std::size_t k = 0; k < light_classes; ++k)
        for (int c = 0; c < 3; ++c) {
            const std::size_t channel = static_cast<std::size_t>(c);
            const double unshadowed =
                static_cast<double>(sums.light[0][k][channel].load(std::memory_order_relaxed));
            const double found =
                static_cast<double>(sums.light[1][k][channel].load(std::memory_order_relaxed));
            const double most = most_ratio * std::max(unshadowed, 0.0);
            const double ratio = unshadowed > 0.0 ? std::clamp(found, 0.0, most) / unshadowed : 0.0;
            result[k][c] = light[k][c] * static_cast<float>(ratio) +
                           static_cast<float>(std::max(found - most, 0.0) / (points * scale_));
        }
    return result;
}

} // namespace lambent::draw
