// Light on surfaces, on SIMD lanes: the passes of src/shading over the fragments of a tile.
#pragma once

#include "draw/cpu/fragments.h"
#include "draw/light_context.h"

#include <span>

namespace lambent::draw {

/// Adds the direct light of `lights` to direct_* of the fragments [begin, end).
void light_directly(const LightContext& context, std::span<const LightSource> lights, std::size_t begin,
                    std::size_t end, Fragments& fragments);

/// Fills irradiance_* and ambient_*.
void light_ambiently(const LightContext& context, std::size_t begin, std::size_t end, Fragments& fragments);

/// Fills reflected_*: the specular light of the environment.
void light_specularly(const LightContext& context, std::size_t begin, std::size_t end, Fragments& fragments);

/// Radiance of the environment along rays of sight, for the background.
struct BackgroundRow {
    float y = 0.0f;      ///< of the pixels' centres
    int first_x = 0;     ///< pixel
    int count = 0;       ///< pixels
    float level = -1.0f; ///< of blur; below 0: the panorama itself
};
/// Writes RGB to three arrays of `count` floats rounded up to 16.
void light_background(const LightContext& context, const RayMap& rays, const BackgroundRow& row,
                      float* const rgb[3]);

} // namespace lambent::draw
