// What the built-in scene `grid` shows of an environment's light without shadows, by brute force in double.
#pragma once

#include "draw/settings.h"
#include "environment/panorama/panorama.h"
#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <vector>

namespace lambent::bench {

/// A pixel that one sphere covers entirely, and its radiance averaged over the pixel.
struct TruePixel {
    int x = 0, y = 0;
    int sphere = 0;           ///< instance of the scene
    glm::dvec3 specular{0.0}; ///< radiance
    glm::dvec3 diffuse{0.0};  ///< radiance
};

struct TruthPlan {
    draw::Camera camera;
    int width = 1280, height = 720;
    int pixels_per_sphere = 100; ///< drawn at random, the same ones each time
};

/// The integral over the panorama interpolated bilinearly, by the text's own BRDF: narrow peaks texel by texel, what
/// is left by 65536 visible normals a pixel, diffuse light by a sum over all texels.
std::vector<TruePixel> true_pixels(const scene::Scene& grid, const environment::Panorama& panorama,
                                   const TruthPlan& plan);

} // namespace lambent::bench
