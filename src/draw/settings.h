// Settings of a picture to draw.
#pragma once

#include "view/picture.h"

#include <optional>

namespace lambent::draw {

// The types that describe a picture are those of view/.
using view::Background, view::Camera, view::Model, view::Orbit, view::RayMap, view::TexelTransfer;
using view::from_scene, view::orbit_camera, view::ray_map;

/// How the phong model samples the environment. matched: points in a spiral, each read at a blur that matches its
/// share of the lobe. report: the report's Hammersley points and formula of the mip level, in the panorama's own mip
/// chain, with block artefacts.
enum class MipLevel { matched, report };

/// The report's order of operations: values read from the environment are decoded, exposed, tone-mapped and encoded
/// before they light surfaces. The passes add up code values: Frame::radiance holds the report's frame buffer before
/// it is clipped at 1. Requires Model::phong, MipLevel::report and TexelTransfer::none.
struct ReportPipeline {
    float exposure = 1.0f; ///< e in docs/REPORT.md
    float contrast = 1.0f; ///< K in docs/REPORT.md
    bool linear = true;    ///< false: nothing is decoded or encoded, as in the report's nonlinear column
};

/// Number of lobe samples of a split-sum picture, which multiplies the mean light of these wide lookups by the table
/// of directional albedo. A single lookup in a cube of lobes seen along the normal, as in game engines, has 2 to 11
/// times the error (docs/ERRORS.md).
constexpr int split_sum_samples = 8;

/// All inputs of a drawing except the scene and the environment.
struct Settings : view::Picture {
    int bounces =
        0; ///< of light: 0: direct light without shadows; 1: with shadows; more: from surface to surface
    int passes = 2;     ///< with bounces: rounds of rays, two samples of each pixel each; 1 to 4096
    float white = 1.0f; ///< with bounces: radiance that is shown as white; errors above it count less
    /// With bounces of light: takes what a picture drawn before by the same renderer knew of the light from surface to surface,
    /// whatever its camera, lights and pose, instead of finding it. For views that move: the picture depends on that one.
    bool keeps_known_light = false;
    int samples = 40; ///< of the specular lobe, 1 to 65536
    MipLevel mip_level = MipLevel::matched;
    float ambient_brightness = 1.0f; ///< factor on the diffuse light of the environment; 2 in the report
    std::optional<ReportPipeline> pipeline; ///< unset: radiance is added up, and tone-mapped at the end
    int edge_samples = 24;                  ///< visibility samples of a pixel at an edge, 1 to 64
    bool layers = false;                    ///< also return the G-buffer and the light of each pass
};

} // namespace lambent::draw
