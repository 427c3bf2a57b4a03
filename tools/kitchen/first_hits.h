// What the panorama's rays meet first, without light: what tells one thing in the picture from another.
#pragma once

#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <vector>

namespace lambent {

struct FirstHit {
    glm::vec3 albedo{1.0f};   ///< base colour, at least a little of each channel; 1 where nothing is
    glm::vec3 normal{0.0f};   ///< unit or shorter, where several were averaged; 0 where nothing is
    glm::vec3 position{0.0f}; ///< metres, from the viewpoint
    float coverage = 0.0f;    ///< share of rays that met something
};

/// Means over `samples` rays for each pixel of a panorama from a viewpoint, rows from the top.
struct PanoramaView {
    glm::vec3 viewpoint{0.0f};
    int width = 0, height = 0;
    int samples = 1;
};
std::vector<FirstHit> first_hits(const scene::Scene& scene, const PanoramaView& view);

} // namespace lambent
