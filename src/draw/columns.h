// What the G-buffer holds.
#pragma once

#include <cstddef>

namespace lambent::draw {

/// What is known of a fragment. Every column is a float per fragment; names ending in r, g, b or x, y, z are vectors.
enum Column : std::size_t {
    // from visibility
    place_x,
    place_y, ///< in the picture, pixels
    hit_distance,
    hit_u,
    hit_v,
    extent, ///< Look::extent
    // the surface
    position_x,
    position_y,
    position_z,
    depth,
    view_x,
    view_y,
    view_z,
    shading_x,
    shading_y,
    shading_z, ///< shading normal, facing the viewer
    mirrored_dx_x,
    mirrored_dx_y,
    mirrored_dx_z,
    mirrored_dy_x,
    mirrored_dy_y,
    mirrored_dy_z,
    base_r,
    base_g,
    base_b, ///< ggx: base colour; phong: Kd
    specular_r,
    specular_g,
    specular_b, ///< phong: Ks
    gloss,      ///< ggx: alpha = perceptual roughness^2; phong: exponent
    metalness,
    occlusion,
    opacity,
    // light
    emitted_r,
    emitted_g,
    emitted_b,
    direct_r,
    direct_g,
    direct_b,
    irradiance_r,
    irradiance_g,
    irradiance_b,
    ambient_r,
    ambient_g,
    ambient_b,
    reflected_r,
    reflected_g,
    reflected_b,
    middle_level, ///< where layers are asked for: of the mips read in the lobe's middle, as a part of the highest
    column_count
};

} // namespace lambent::draw
