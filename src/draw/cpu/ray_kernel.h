// The choice of rays at fragments, in SIMD lanes: a pass of src/shading.
#pragma once

#include "draw/cpu/fragments.h"
#include "draw/light_context.h"

#include <cstddef>
#include <span>

namespace lambent::draw {

/// What all fragments of a wave share.
struct RayChoice {
    std::span<const LightSource> lights; ///< of the scene and of the picture
    float rays = 4.0f;                   ///< rays that ask the environment at about the same place; above 0
};

/// Fills the columns lobe_*, lamp_* and light_* of the fragments [begin, end) by their random numbers. Where there is
/// no ray to a light its distance is 0.
void choose_rays(const LightContext& context, const RayChoice& choice, std::size_t begin, std::size_t end,
                 Fragments& fragments);

/// Widens the lobes of the fragments [begin, end) by what their footprints mirror, and makes the footprints points: the rays
/// of a surface that was itself met by a ray of a wide lobe need not resolve more. [Kaplanyan and Dachsbacher 2013, "Path
/// space regularization for holistic and robust light transport"]
void soften(Model model, std::size_t begin, std::size_t end, Fragments& fragments);

} // namespace lambent::draw
