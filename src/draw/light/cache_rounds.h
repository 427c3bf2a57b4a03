// How a cache of light is filled: places and what rays found there once, the light that they send each other in rounds.
#pragma once

#include "draw/light/world_cache.h"

#include <array>
#include <memory>
#include <vector>

namespace lambent::draw {

/// A place of the scene, what rays that leave it found, and the place where the ray along a lobe ended.
struct PlaceSample {
    CachePoint place;
    /// What arrives from the environment and from lights, and what the further place emits.
    CachedLight light;
    bool has_further = false; ///< whether the ray met a surface
    CachePoint further;
    std::array<glm::vec3, light_classes> further_light{}; ///< that it would send without shadows
    std::array<glm::vec3, light_classes> share{}; ///< of its light, what the place sends on in each class
};

struct CacheSizes {
    float unit = 1.0f;  ///< as of WorldCache
    float side = 0.01f; ///< as of CacheCells; larger ones are taken where there would be too many cells
};

/// A cache filled with the samples, which are in parts of any size. In each round places take the light of further ones
/// from the round before, so that each adds a bounce to the one that the samples have: `rounds` of them, 1 or more, or
/// fewer where the light does not grow any more. The result does not depend on the number of threads.
std::shared_ptr<const WorldCache> fill_cache(const std::vector<std::vector<PlaceSample>>& samples,
                                             CacheSizes sizes, int rounds);

} // namespace lambent::draw
