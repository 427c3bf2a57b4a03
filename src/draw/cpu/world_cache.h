// Light at places of the scene, pooled over what rays found there.
#pragma once

#include "draw/cpu/light_class.h"

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

/// Light of both classes that a surface sends: without shadows, and an estimate of the true light.
struct CachedLight {
    std::array<glm::vec3, light_classes> unshadowed{}, found{};
};

/// How much light arrives at places of the scene, as the ratio of true to unshadowed light of all points of a cell: a cube
/// of space, a range of normals and one instance. Where a cell has few points, wider cells are used. [Binder, Fricke and
/// Keller 2018, "Fast path space filtering by jittered spatial hashing"; ratio: Heitz, Hill and McGuire 2018]
///
/// Sums are integers, so that they do not depend on the order in which threads add.
class WorldCache {
public:
    struct Sizes {
        float unit = 1.0f; ///< a typical radiance: sums resolve a four-millionth of it
        float side =
            0.01f; ///< of the smallest cells, over the distance from the camera; actual ones are up to twice as wide
    };
    explicit WorldCache(const Sizes& sizes);

    /// Adds the light at a point. Any number of threads may call it at once.
    void add(const CachePoint& point, const CachedLight& light);

    /// Must be called between the last add() and the first true_light().
    void finish();

    /// The true light at a point whose unshadowed light is `light`, in its classes. Where the cache knows little, that of the
    /// instance's or of the scene's points serves.
    std::array<glm::vec3, light_classes> true_light(const CachePoint& point,
                                                    const std::array<glm::vec3, light_classes>& light) const;

    /// Side of the smallest cells around points at that distance from the camera, metres.
    float side_at(float distance) const;

    /// Whether it holds as many cells as it can: later points were lost, and which depends on the threads.
    bool is_full() const { return cells_ > most_cells; }

private:
    static constexpr std::size_t capacity = std::size_t{1} << 17, most_cells = capacity / 4 * 3;
    static constexpr int levels =
        5; ///< the last two are an instance's and the scene's, one cell for each side

    struct Cell {
        std::atomic<std::uint64_t> key = 0;    ///< 0: empty
        std::atomic<std::uint32_t> parent = 0; ///< the next wider cell around it
        std::atomic<std::uint8_t> level = 0;
        std::atomic<std::int64_t> points = 0;
        std::array<std::array<std::array<std::atomic<std::int64_t>, 3>, light_classes>, 2> sums{};
    };

    std::uint64_t key_of(const CachePoint& point, int level) const;
    const Cell* find(std::uint64_t key) const;
    Cell* find_or_make(std::uint64_t key);
    void add(Cell& cell, const CachedLight& light) const;
    static void take_away(Cell& from, const Cell& cell);
    std::array<glm::vec3, light_classes> light_of(const Cell& cell,
                                                  const std::array<glm::vec3, light_classes>& light) const;

    std::unique_ptr<Cell[]> table_;
    std::atomic<std::size_t> cells_ = 0;
    double scale_; ///< of the integers
    float finest_side_;
};

} // namespace lambent::draw
