// Cells of places, of several sizes, and which of them speaks for a place.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace lambent::draw {

/// A surface point, as the cache finds its place.
struct CachePoint {
    glm::vec3 position{0.0f}, normal{0.0f};
    std::uint32_t instance = 0;
    bool front = true; ///< whether the front of the triangle is lit: inside and outside of a thin wall differ
    float distance = 1.0f; ///< from the camera, metres: cells are a hundredth of it wide
};

/// A cell is a cube of space, a range of normals and one instance's side, in three sizes; or a side of an instance; or a
/// side of the scene. [Binder, Fricke and Keller 2018, "Fast path space filtering by jittered spatial hashing"]
///
/// First all points are counted; then the cells that speak are settled: those with enough points, without the points for
/// which smaller cells speak. Rays meet dark corners most often: a wide cell with such points would say that the bright
/// places around them are as dark.
class CacheCells {
public:
    static constexpr std::uint32_t none = ~0u;

    /// `side`: of the smallest cells, over the distance from the camera; actual ones are up to twice as wide.
    explicit CacheCells(float side);

    /// Counts a point. Any number of threads may call it at once. Points that are not finite do not count.
    void count(const CachePoint& point);

    /// Whether there are as many cells as there can be: later points were lost, and which depends on the threads.
    bool is_full() const { return cells_ > most_cells; }

    /// Ends the counting, unless there are too many cells; only those that speak are kept.
    void settle();

    /// How many cells speak.
    std::uint32_t size() const { return speakers_; }

    /// The number, below size(), of the cell that speaks for a point, counted or not; none where no point was counted.
    std::uint32_t speaker_for(const CachePoint& point) const;

    /// The cells that a counted point belongs to: the one that speaks for it, its instance's if that has so few points
    /// elsewhere that it speaks with all, and the scene's. Those that it does not have are none.
    using Membership = std::array<std::uint32_t, 3>;
    Membership cells_of(const CachePoint& point) const;

    /// Side of the smallest cells around points at that distance from the camera, metres.
    float side_at(float distance) const;

private:
    static constexpr std::size_t capacity = std::size_t{1} << 18, most_cells = capacity / 4 * 3;

    struct Cell {
        std::atomic<std::uint64_t> key = 0;    ///< 0: empty
        std::atomic<std::uint32_t> parent = 0; ///< the next wider cell around it
        std::atomic<std::int32_t> points = 0;  ///< from settle() on without those of smaller speakers
        std::uint32_t speaker = none;          ///< its number
        std::atomic<std::uint8_t> level = 0;
        bool whole = false; ///< an instance's cell that speaks with all of its points
    };

    std::uint64_t key_of(const CachePoint& point, int level) const;
    struct Speaker {
        std::uint64_t key = 0; ///< 0: empty
        std::uint32_t number = none;
        bool whole = false;
    };

    const Speaker* find(const CachePoint& point, int level) const;
    Cell* find_or_make(std::uint64_t key);
    void settle_places(int level);
    void settle_wholes();
    void keep_speakers();

    std::unique_ptr<Cell[]> table_; ///< while points are counted
    std::vector<Speaker>
        kept_; ///< a table of a power of two of places, mostly empty: it fits in a core's cache
    std::atomic<std::size_t> cells_ = 0;
    std::uint32_t speakers_ = 0;
    float finest_side_;
};

} // namespace lambent::draw
