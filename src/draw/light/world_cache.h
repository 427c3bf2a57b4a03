// Light at places of the scene, pooled over what rays found there.
#pragma once

#include "draw/light/cache_cells.h"
#include "draw/light/light_class.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace lambent::draw {

/// Light of both classes that a surface sends: without shadows, and an estimate of the true light.
struct CachedLight {
    std::array<glm::vec3, light_classes> unshadowed{}, found{};
};

/// How much light arrives at places of the scene: the ratio of true to unshadowed light of all points for which a cell
/// speaks. [ratio: Heitz, Hill and McGuire 2018, "Combining analytic direct illumination and stochastic shadows"]
///
/// Sums are integers, so that they do not depend on the order in which threads add.
class WorldCache {
public:
    /// `cells`: settled. `unit`: a typical radiance, above 0; sums resolve a four-millionth of it.
    WorldCache(std::shared_ptr<const CacheCells> cells, float unit);

    const CacheCells& cells() const { return *cells_; }

    /// Adds the light of a counted point to its cells. Any number of threads may call it at once.
    void add(const CacheCells::Membership& of, const CachedLight& light);

    /// The true light at a point whose unshadowed light is `light`, in its classes. `speaker`: the cell that speaks for it;
    /// where there is none, nothing is known, and the light is without shadows.
    std::array<glm::vec3, light_classes> true_light(std::uint32_t speaker,
                                                    const std::array<glm::vec3, light_classes>& light) const;
    std::array<glm::vec3, light_classes> true_light(const CachePoint& point,
                                                    const std::array<glm::vec3, light_classes>& light) const
    {
        return true_light(cells_->speaker_for(point), light);
    }

private:
    struct Sums {
        std::atomic<std::int64_t> points = 0;
        std::array<std::array<std::array<std::atomic<std::int64_t>, 3>, light_classes>, 2> light{};
    };

    void add(Sums& sums, const CachedLight& light) const;

    std::shared_ptr<const CacheCells> cells_;
    std::vector<Sums> sums_; ///< of the cells that speak
    double scale_;           ///< of the integers
};

} // namespace lambent::draw
