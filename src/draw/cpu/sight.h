// Rays of sight through places in the picture, and what they see: backs of one-sided surfaces are looked through.
#pragma once

#include "draw/settings.h"
#include "draw/cpu/prepared_scene.h"

#include <cstddef>
#include <vector>

namespace lambent::draw {

using trace::Hit, trace::Rays;

/// One look into the scene.
struct Look {
    float x = 0.0f, y = 0.0f; ///< place in the picture, in pixels
    float near = 0.0f;        ///< where the ray starts, in multiples of its direction
    std::uint32_t pixel = 0;  ///< of the tile
    float weight = 1.0f;      ///< share of the pixel
    float extent = 1.0f;      ///< side of the square that is lit as one, in pixels
    Hit hit;
};

/// Looks through a scene; keeps its buffers from call to call.
class Sight {
public:
    Sight(const PreparedScene& scene, const RayMap& map);

    /// Fills the hits of all looks; from beyond Visibility::furthest nothing is seen. Looks next to each other should be next to each other in the picture.
    void look(std::vector<Look>& looks);

private:
    void trace(const std::vector<Look*>& looks);

    const PreparedScene& scene_;
    RayMap map_;
    bool within_reach_; ///< of Visibility
    Rays rays_;
    std::vector<Hit> hits_;
    std::vector<Look*> waiting_;
};

} // namespace lambent::draw
