// The surfaces that a panorama's rays hit first, without light. The noise filter tells surfaces apart by them.
#pragma once

#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <vector>

namespace lambent {

struct FirstHit {
    glm::vec3 albedo{1.0f};   ///< base colour, each channel at least 0.02; 1 where nothing is hit
    glm::vec3 normal{0.0f};   ///< unit, shorter where normals were averaged; 0 where nothing is hit
    glm::vec3 position{0.0f}; ///< metres, from the viewpoint
    float coverage = 0.0f;    ///< share of rays that hit a surface
};

/// A panorama of `samples` rays per pixel from a viewpoint.
struct PanoramaView {
    glm::vec3 viewpoint{0.0f};
    int width = 0, height = 0;
    int samples = 1;
};

/// The means over each pixel's rays, rows from the top.
std::vector<FirstHit> first_hits(const scene::Scene& scene, const PanoramaView& view);

} // namespace lambent
