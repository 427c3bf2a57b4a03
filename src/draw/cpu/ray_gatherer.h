// Light by rays: shadows, and the light of surfaces that stand in its way.
#pragma once

#include "draw/cpu/light_sums.h"
#include "draw/cpu/ray_step.h"
#include "draw/cpu/ray_wave.h"
#include "draw/light/cache_rounds.h"
#include "draw/light/sample_plan.h"

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

    /// A pass, and the samples that pixels of the sums' area get in it.
    struct Pass {
        int number;
        const SamplePlan& plan;
    };
    /// Adds the samples of a pass of the area's pixels to the sums. `frame`: the picture without shadows; pixels that no
    /// surface covers get no rays.
    void gather(const TileArea& area, const Pass& pass, const Frame& frame, LightSums& sums);

    /// Where the rays of some pixels meet surfaces.
    struct Places {
        int spacing;           ///< one pixel in spacing^2; 1 or more
        std::uint32_t samples; ///< of each of these pixels
        bool further;          ///< whether the light of the surfaces that these places see is wanted
    };
    /// Adds these places, with what the rays that leave them found.
    void find_places(const TileArea& area, const Places& wanted, const Frame& frame,
                     std::vector<PlaceSample>& places);

private:
    void add_places(bool further, std::vector<PlaceSample>& places);
    void add_further(std::vector<PlaceSample>& places);
    bool is_covered(const Frame& frame, int x, int y) const { return frame.radiance.pixel(x, y)[3] > 0.0f; }
    void add_sight(int x, int y, std::uint32_t sample);
    void find_seen();
    void gather_wave(float together, LightSums& sums);
    void light_unshadowed(RayWave& wave);
    void soften_all(RayWave& wave) const;
    CachePoint point_of(const RayWave& wave, std::size_t at) const;
    std::array<glm::vec3, light_classes> unshadowed_light(const Fragments& f, std::size_t at) const;
    glm::vec3 emitted(const RayWave& wave, std::size_t at) const;
    void emission_of_hits(const RayStep& step);
    void light_of_hits(RayStep& step, const WorldCache* cache);
    bool is_near(const RayWave& met, std::size_t at) const;
    bool mirrors(const RayWave& met, std::size_t at) const;
    glm::vec3 mirrored(const RayWave& met, std::size_t at, const RayLight& found) const;
    void follow(float together);

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
    std::vector<std::size_t> place_of_; ///< of each of the first step's fragments
};

} // namespace lambent::draw
