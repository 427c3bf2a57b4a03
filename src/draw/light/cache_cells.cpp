#include "draw/light/cache_cells.h"

#include "base/hash.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

namespace lambent::draw {
namespace {

// The levels of cells: places of three sizes, an instance's side, the scene's side.
constexpr int places = 3, of_instance = places, of_scene = places + 1;

// Points with which a cell speaks; the scene's needs only one.
constexpr std::int32_t enough_points = 16;

bool is_finite(const CachePoint& point)
{
    const glm::vec3 sum = point.position + point.normal;
    return std::isfinite(sum.x + sum.y + sum.z) && std::isfinite(point.distance);
}

// The range of one coordinate of a normal: one of seven in the smallest cells, in others one of five, made of these.
long turn_of(float coordinate, int level)
{
    const long narrow = std::lround(coordinate * 3.0f);
    return level == 0 ? narrow : std::lround(static_cast<float>(narrow) * (2.0f / 3.0f));
}

} // namespace

CacheCells::CacheCells(float side) : table_(std::make_unique<Cell[]>(capacity)), finest_side_(side) {}

// Sides are powers of two, so that neighbours at slightly different distances share a cell.
float CacheCells::side_at(float distance) const
{
    int exponent = 0;
    std::frexp(std::max(distance, 1e-30f) * finest_side_, &exponent);
    return std::ldexp(1.0f, exponent);
}

std::uint64_t CacheCells::key_of(const CachePoint& point, int level) const
{
    const auto kind = static_cast<std::uint32_t>(2 * level + (point.front ? 1 : 0));
    if (level >= places)
        return std::uint64_t{1} + hashed(level == of_instance ? point.instance : 0u, kind);
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

// Null where there is none.
const CacheCells::Speaker* CacheCells::find(const CachePoint& point, int level) const
{
    const std::uint64_t key = key_of(point, level);
    const std::size_t mask = kept_.size() - 1;
    for (std::size_t at = key & mask;; at = (at + 1) & mask) {
        if (kept_[at].key == key)
            return &kept_[at];
        if (kept_[at].key == 0)
            return nullptr;
    }
}

// Null where there are too many.
CacheCells::Cell* CacheCells::find_or_make(std::uint64_t key)
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

void CacheCells::count(const CachePoint& point)
{
    if (!is_finite(point))
        return;
    std::uint32_t parent = 0;
    for (int level = of_scene; level >= 0; --level)
        if (Cell* const cell = find_or_make(key_of(point, level))) {
            cell->parent.store(parent, std::memory_order_relaxed);
            cell->level.store(static_cast<std::uint8_t>(level), std::memory_order_relaxed);
            cell->points.fetch_add(1, std::memory_order_relaxed);
            parent = static_cast<std::uint32_t>(cell - table_.get());
        }
}

// Of the cells of one size those with enough points speak; the places around them have these points no more.
void CacheCells::settle_places(int level)
{
    for (std::size_t i = 0; i < capacity; ++i) {
        Cell& cell = table_[i];
        if (cell.key == 0 || cell.level != level || cell.points < enough_points)
            continue;
        cell.speaker = speakers_++;
        for (std::uint32_t at = cell.parent; table_[at].level < places; at = table_[at].parent)
            table_[at].points -= cell.points;
    }
}

// Instances speak for what is left of their points, or with all of them where that is little; the scene with all.
void CacheCells::settle_wholes()
{
    std::vector<std::int32_t> spoken_for(capacity, 0); // points of an instance's cell
    for (std::size_t i = 0; i < capacity; ++i) {
        if (table_[i].speaker == none)
            continue;
        std::uint32_t at = table_[i].parent;
        while (table_[at].level < places)
            at = table_[at].parent;
        spoken_for[at] += table_[i].points;
    }
    for (std::size_t i = 0; i < capacity; ++i) {
        Cell& cell = table_[i];
        if (cell.key == 0 || cell.level < places)
            continue;
        if (cell.level == of_instance) {
            cell.whole = cell.points - spoken_for[i] < enough_points;
            if (cell.points < enough_points)
                continue;
        }
        cell.speaker = speakers_++;
    }
}

void CacheCells::keep_speakers()
{
    kept_.assign(std::bit_ceil(std::size_t{4} * speakers_ + 1), {});
    for (std::size_t i = 0; i < capacity; ++i) {
        const Cell& cell = table_[i];
        if (cell.speaker == none)
            continue;
        std::size_t at = cell.key & (kept_.size() - 1);
        while (kept_[at].key != 0)
            at = (at + 1) & (kept_.size() - 1);
        kept_[at] = {cell.key, cell.speaker, cell.whole};
    }
    table_.reset();
}

void CacheCells::settle()
{
    for (int level = 0; level < places; ++level)
        settle_places(level);
    settle_wholes();
    keep_speakers();
}

std::uint32_t CacheCells::speaker_for(const CachePoint& point) const
{
    for (int level = is_finite(point) ? 0 : of_instance; level <= of_scene; ++level)
        if (const Speaker* const speaker = find(point, level))
            return speaker->number;
    return none;
}

CacheCells::Membership CacheCells::cells_of(const CachePoint& point) const
{
    if (!is_finite(point))
        return {none, none, none};
    Membership cells = {speaker_for(point), none, none};
    if (const Speaker* const instance = find(point, of_instance); instance && instance->whole)
        cells[1] = instance->number;
    if (const Speaker* const scene = find(point, of_scene))
        cells[2] = scene->number;
    for (std::size_t i = 1; i < cells.size(); ++i)
        if (cells[i] == cells[i - 1] || cells[i] == cells[0])
            cells[i] = none;
    return cells;
}

} // namespace lambent::draw
