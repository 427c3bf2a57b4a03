// Light by rays: shadows, and the light of surfaces that stand in its way.
#pragma once

#include "draw/cpu/light_sums.h"
#include "draw/cpu/ray_step.h"
#include "draw/cpu/ray_wave.h"
#include "draw/cpu/world_cache.h"

#include <cstdint>
#include <vector>

namespace lambent::draw {

/// Traces the rays of tiles, one tile after the other; each thread has a gatherer of its own.
///
/// A sample is a camera ray through a random point of its pixel, and the rays that leave the surface that it meets. Light is
/// found in pairs, with and without shadows, by the same rays, so that noise is only in what shadows change. [Heitz, Hill
/// and McGuire 2018, "Combining analytic direct illumination and stochastic shadows"] What stops a ray is lit by the passes
/// of src/shading, and by what the cache knows about that place.
class RayGatherer {
public:
    /// `cache`: the light of what stops rays; null: it is black, but for what it emits.
    RayGatherer(const PictureContext& picture, const WorldCache* cache);

    /// Adds sample number `sample` of the area's pixels to the sums. `frame`: the picture without shadows; pixels that no
    /// surface covers get no rays.
    void gather(const TileArea& area, std::uint32_t sample, const Frame& frame, LightSums& sums);

    /// Adds to `cache` what the rays of one pixel in `spacing`^2 find where they meet surfaces.
    struct Filling {
        WorldCache& cache;
        int spacing;           ///< 1 or more
        std::uint32_t sample;  ///< number of the first sample of each pixel
        std::uint32_t step;    ///< to the number of its next
        std::uint32_t samples; ///< of each pixel
    };
    void fill(const TileArea& area, const Filling& filling, const Frame& frame);

private:
    void fill(const TileArea& area, WorldCache& cache, std::uint32_t sample, int spacing, const Frame& frame);
    void look(const TileArea& area, std::uint32_t sample, int spacing, const Frame& frame);
    void light_unshadowed(RayWave& wave);
    void soften_all(RayWave& wave) const;
    CachePoint point_of(const RayWave& wave, std::size_t at) const;
    std::array<glm::vec3, light_classes> unshadowed_light(const Fragments& f, std::size_t at) const;
    glm::vec3 emitted(const RayWave& wave, std::size_t at) const;
    void light_of_hits(RayStep& step, const WorldCache* cache);
    bool is_near(const RayWave& met, std::size_t at) const;
    bool mirrors(const RayWave& met, std::size_t at) const;
    glm::vec3 mirrored(const RayWave& met, std::size_t at, const RayLight& found) const;
    void follow(std::uint32_t sample);

    const PictureContext& picture_;
    const WorldCache* cache_;
    RayWave seen_, near_;
    RayStep first_, second_;       ///< the steps from what the camera sees, and from what that step met
    std::vector<WaveRay> sights_;  ///< camera rays; owner: the pixel's number in the picture
    std::vector<WaveRay> further_; ///< rays along lobes whose hits are asked further
    struct Asked {
        std::size_t at; ///< the hit's index in the first step's fragments
        bool near;      ///< whether rays replace all of its light
    };
    std::vector<Asked> asked_; ///< of each of further_
    std::vector<glm::vec3> near_light_;
    std::vector<glm::vec3> light_; ///< of what a step's rays met
    std::vector<RayLight> found_;
};

} // namespace lambent::draw
