// Camera rays through positions in the picture, and their hits; back faces of one-sided surfaces are skipped.
#pragma once

#include "draw/settings.h"
#include "draw/cpu/prepared_scene.h"

#include <cstddef>
#include <vector>

namespace lambent::draw {

using trace::Hit, trace::Rays;

/// A visibility sample: a camera ray and its hit.
struct Look {
    float x = 0.0f, y = 0.0f; ///< position in the picture, pixels
    float near = 0.0f;        ///< where the ray starts, in multiples of its direction
    std::uint32_t pixel = 0;  ///< index in the tile
    float weight = 1.0f;      ///< share of the pixel
    float extent = 1.0f;      ///< side of the square that the look covers, pixels
    Hit hit;
};

/// Traces looks through a scene; reuses its buffers from call to call.
class Sight {
public:
    Sight(const PreparedScene& scene, const RayMap& map);

    /// Fills the hits of all looks. Nothing is hit if camera rays exceed Visibility::furthest. For speed, consecutive
    /// looks should be neighbours in the picture.
    void look(std::vector<Look>& looks);

private:
    void trace(const std::vector<Look*>& looks);

    const PreparedScene& scene_;
    RayMap map_;
    bool within_reach_; ///< see draw/reach.h
    Rays rays_;
    std::vector<Hit> hits_;
    std::vector<Look*> waiting_;
};

} // namespace lambent::draw
