// How to draw a picture.
#pragma once

#include "view/picture.h"

namespace lambent::draw {

// The words for what is drawn are those of view/.
using view::Background, view::Camera, view::Model, view::Orbit, view::RayMap, view::TexelTransfer;
using view::from_scene, view::orbit_camera, view::ray_map;

/// How the phong model samples the environment: points in a spiral, each read at a blur that matches its share of the
/// lobe; or the report's Hammersley points and formula of the level in the panorama's own mip chain, which shows blocks.
enum class MipLevel { matched, report };

/// How many of the lobe's samples a split-sum picture takes: the mean light of so few wide lookups times the table of
/// what a surface reflects in all. One lookup in a cube of lobes seen along the normal, as engines do, is 2 to 11 times
/// as far off (docs/ERRORS.md).
constexpr int split_sum_samples = 8;

/// Everything a drawing depends on but the scene and the environment.
struct Settings : view::Picture {
    int samples = 40; ///< of the specular lobe, 1 to 65536
    MipLevel mip_level = MipLevel::matched;
    float ambient_brightness = 1.0f; ///< factor on the diffuse light of the environment; the report's is 2
    int edge_samples = 4;            ///< per pixel where surfaces end or bend, 1 to 64
    bool layers = false;             ///< also return the G-buffer and the light of each pass
};

} // namespace lambent::draw
