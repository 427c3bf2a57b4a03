// How to draw a picture.
#pragma once

#include "view/picture.h"

#include <optional>

namespace lambent::draw {

// The words for what is drawn are those of view/.
using view::Background, view::Camera, view::Model, view::Orbit, view::RayMap, view::TexelTransfer;
using view::from_scene, view::orbit_camera, view::ray_map;

/// How the phong model samples the environment: points in a spiral, each read at a blur that matches its share of the
/// lobe; or the report's Hammersley points and formula of the level in the panorama's own mip chain, which shows blocks.
enum class MipLevel { matched, report };

/// The report's own order of things: values read from the environment are decoded, exposed, bent by its tone curve and encoded
/// before they light anything, and what its passes add up are codes: Frame::radiance is the report's frame buffer, from 0
/// to where it is cut at 1. For Model::phong with MipLevel::report, texels as TexelTransfer::none.
struct ReportPipeline {
    float exposure = 1.0f; ///< e
    float contrast = 1.0f; ///< K
    bool linear = true;    ///< false: nothing is decoded or encoded, as in the report's nonlinear column
};

/// How many of the lobe's samples a split-sum picture takes: the mean light of so few wide lookups times the table of
/// what a surface reflects in all. One lookup in a cube of lobes seen along the normal, as engines do, is 2 to 11 times
/// as far off (docs/ERRORS.md).
constexpr int split_sum_samples = 8;

/// Everything a drawing depends on but the scene and the environment.
struct Settings : view::Picture {
    int samples = 40; ///< of the specular lobe, 1 to 65536
    MipLevel mip_level = MipLevel::matched;
    float ambient_brightness = 1.0f; ///< factor on the diffuse light of the environment; the report's is 2
    std::optional<ReportPipeline> pipeline; ///< unset: light is added up, and shown at the end
    int edge_samples = 4;                   ///< per pixel where surfaces end or bend, 1 to 64
    bool layers = false;                    ///< also return the G-buffer and the light of each pass
};

} // namespace lambent::draw
