// Direct light, diffuse light of the environment and the background, in SIMD lanes: passes of src/shading over the
// fragments of a tile.
#pragma once

#include "draw/cpu/fragments.h"
#include "draw/light_context.h"

#include <span>

namespace lambent::draw {

/// Fills column_direct of the fragments [begin, end) with the light of `lights`.
void light_directly(const LightContext& context, std::span<const LightSource> lights, std::size_t begin,
                    std::size_t end, Fragments& fragments);

/// Fills column_irradiance and column_ambient: the environment's diffuse light.
void light_ambiently(const LightContext& context, std::size_t begin, std::size_t end, Fragments& fragments);

/// Adjacent pixels of a row whose background is computed.
struct BackgroundRow {
    float y = 0.0f;      ///< of the pixels' centres, in the picture
    int first_x = 0;     ///< of the first pixel
    int count = 0;       ///< pixels
    float level = -1.0f; ///< of blur; negative: the panorama itself
};
/// Writes the environment's radiance along the row's camera rays to three arrays, R, G and B, whose size is `count`
/// rounded up to a multiple of 16.
void light_background(const LightContext& context, const RayMap& rays, const BackgroundRow& row,
                      float* const rgb[3]);

} // namespace lambent::draw
