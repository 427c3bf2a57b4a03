#include "draw/cpu/world_cache.h"

#include "draw/cpu/random_points.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lambent::draw {
namespace {

// Cells of the first levels are places; those of the others are all points of an instance, and of the scene.
constexpr int places = 3;

// A cell with fewer points is used only if it is the widest.
constexpr std::int64_t enough_points = 16;

// Light of other surfaces can exceed the unshadowed light; by more than this it is kept as an amount, not as a ratio.
constexpr float most_ratio = 4.0f;

bool is_finite(const CachePoint& point)
{
    const glm::vec3 sum = point.position + point.normal;
    return std::isfinite(sum.x + sum.y + sum.z) && std::isfinite(point.distance);
}

// The range of one coordinate of a normal: sevenths in the smallest cells, in others fifths made of these.
long turn_of(float coordinate, int level)
{
    const long narrow = std::lround(coordinate * 3.0f);
    return level == 0 ? narrow : std::lround(static_cast<float>(narrow) * (2.0f / 3.0f));
}

} // namespace

WorldCache::WorldCache(const Sizes& sizes)
    : table_(std::make_unique<Cell[]>(capacity)),
      scale_(0x1p22 / static_cast<double>(std::max(sizes.unit, 1e-30f))), finest_side_(sizes.side)
{
}

// Sides are powers of two, so that neighbours at slightly different distances share a cell.
float WorldCache::side_at(float distance) const
{
    int exponent = 0;
    std::frexp(std::max(distance, 1e-30f) * finest_side_, &exponent);
    return std::ldexp(1.0f, exponent);
}

std::uint64_t WorldCache::key_of(const CachePoint& point, int level) const
{
    const auto kind = static_cast<std::uint32_t>(2 * level + (point.front ? 1 : 0));
    if (level >= places)
        return std::uint64_t{1} + hashed(level == places ? point.instance : 0u, kind);
    const float side = side_at(point.distance) * static_cast<float>(1 << (2 * level));
    std::uint32_t low = hashed(point.instance, kind);
    low = hashed(low, static_cast<std::uint32_t>(std::ilogb(side)));
    std::uint32_t high = hashed(low, 0x5bd1e995u);
    for (int axis = 0; axis < 3; ++axis) {
        const double cell = std::floor(static_cast<double>(point.position[axis]) / static_cast<double>(side));
        const auto place =
            static_cast<std::uint32_t>(static_cast<std::int64_t>(std::clamp(cell, -0x1p40, 0x1p40)));
        const auto turn = static_cast<std::uint32_t>(turn_of(point.normal[axis], level) + 8);
        low = hashed(hashed(low, place), turn);
        high = hashed(hashed(high, place), turn);
    }
    const std::uint64_t key = (std::uint64_t{high} << 32) | low;
    return key == 0 ? 1 : key;
}

const WorldCache::Cell* WorldCache::find(std::uint64_t key) const
{
    for (std::size_t at = key % capacity;; at = (at + 1) % capacity) {
        const std::uint64_t there = table_[at].key.load(std::memory_order_relaxed);
        if (there == key)
            return &table_[at];
        if (there == 0)
            return nullptr;
    }
}

// Null where the cache is full.
WorldCache::Cell* WorldCache::find_or_make(std::uint64_t key)
{
    for (std::size_t at = key % capacity;; at = (at + 1) % capacity) {
        std::uint64_t there = table_[at].key.load(std::memory_order_relaxed);
        if (there == 0) {
            if (is_full())
                return nullptr;
            if (table_[at].key.compare_exchange_strong(there, key)) {
                ++cells_;
                return &table_[at];
            }
        }
        if (there == key)
            return &table_[at];
    }
}

void WorldCache::add(Cell& cell, const CachedLight& light) const
{
    const auto fixed = [&](float value) {
        const double scaled = static_cast<double>(value) * scale_;
        return static_cast<std::int64_t>(std::isfinite(scaled) ? std::clamp(scaled, -0x1p44, 0x1p44) : 0.0);
    };
    for (std::size_t k = 0; k < light_classes; ++k)
        for (std::size_t c = 0; c < 3; ++c) {
            const int channel = static_cast<int>(c);
            cell.sums[0][k][c].fetch_add(fixed(light.unshadowed[k][channel]), std::memory_order_relaxed);
            cell.sums[1][k][c].fetch_add(fixed(light.found[k][channel]), std::memory_order_relaxed);
        }
    cell.points.fetch_add(1, std::memory_order_relaxed);
}

void WorldCache::add(const CachePoint& point, const CachedLight& light)
{
    if (!is_finite(point))
        return;
    std::uint32_t parent = 0;
    for (int level = levels - 1; level >= 0; --level)
        if (Cell* const cell = find_or_make(key_of(point, level))) {
            cell->parent.store(parent, std::memory_order_relaxed);
            cell->level.store(static_cast<std::uint8_t>(level), std::memory_order_relaxed);
            add(*cell, light);
            parent = static_cast<std::uint32_t>(cell - table_.get());
        }
}

void WorldCache::take_away(Cell& from, const Cell& cell)
{
    from.points -= cell.points;
    for (std::size_t i = 0; i < cell.sums.size(); ++i)
        for (std::size_t k = 0; k < light_classes; ++k)
            for (std::size_t c = 0; c < 3; ++c)
                from.sums[i][k][c] -= cell.sums[i][k][c];
}

// Takes the points of cells with enough away from the wider places around them, the smallest cells first. From an
// instance they are taken together in the end, if enough are left; the scene keeps all, so that there is always an answer.
void WorldCache::finish()
{
    std::vector<std::int64_t> elsewhere(capacity, 0); // points of an instance's cell that are in smaller ones
    std::vector<std::pair<const Cell*, std::uint32_t>> of_instances;
    for (int level = 0; level < places; ++level)
        for (std::size_t i = 0; i < capacity; ++i) {
            const Cell& cell = table_[i];
            if (cell.key == 0 || cell.level != level || cell.points < enough_points)
                continue;
            std::uint32_t wider = cell.parent;
            for (; table_[wider].level < places; wider = table_[wider].parent)
                take_away(table_[wider], cell);
            elsewhere[wider] += cell.points;
            of_instances.emplace_back(&cell, wider);
        }
    for (std::size_t i = 0; i < capacity; ++i)
        elsewhere[i] = table_[i].level == places ? table_[i].points - elsewhere[i] : 0;
    for (const auto& [cell, instance] : of_instances)
        if (elsewhere[instance] >= enough_points)
            take_away(table_[instance], *cell);
}

std::array<glm::vec3, light_classes>
WorldCache::light_of(const Cell& cell, const std::array<glm::vec3, light_classes>& light) const
{
    const double points = static_cast<double>(cell.points.load(std::memory_order_relaxed));
    std::array<glm::vec3, light_classes> result{};
    for (std::size_t k = 0; k < light_classes; ++k)
        for (int c = 0; c < 3; ++c) {
            const auto& sums = cell.sums;
            const std::size_t channel = static_cast<std::size_t>(c);
            const double unshadowed =
                static_cast<double>(sums[0][k][channel].load(std::memory_order_relaxed));
            const double found = static_cast<double>(sums[1][k][channel].load(std::memory_order_relaxed));
            const double most = static_cast<double>(most_ratio) * std::max(unshadowed, 0.0);
            const double ratio = unshadowed > 0.0 ? std::clamp(found, 0.0, most) / unshadowed : 0.0;
            result[k][c] = light[k][c] * static_cast<float>(ratio) +
                           static_cast<float>(std::max(found - most, 0.0) / (points * scale_));
        }
    return result;
}

std::array<glm::vec3, light_classes>
WorldCache::true_light(const CachePoint& point, const std::array<glm::vec3, light_classes>& light) const
{
    for (int level = is_finite(point) ? 0 : places; level < levels; ++level) {
        const Cell* const cell = find(key_of(point, level));
        const std::int64_t points = cell ? cell->points.load(std::memory_order_relaxed) : 0;
        if (points >= enough_points || (points > 0 && level == levels - 1))
            return light_of(*cell, light);
    }
    return light;
}

} // namespace lambent::draw
