// How much of a mask's texel is there, so that coarser levels can keep it.
#pragma once

#include "scene/scene.h"

namespace lambent::draw {

/// A texel's alpha with that of the eight around it, row by row: [1][1] is its own.
struct AlphaAround {
    float alpha[3][3];
};

/// Share of the texel's area, 0 to 1, where its alpha reaches `least` as a magnified picture shows it: bilinear between the
/// middles of texels, or the same all over where the sampler magnifies to blocks. Exact along rows, by eight rows.
float covered_share(const AlphaAround& around, float least, bool in_blocks);

/// The alpha that a material's base colour texture needs for its mask to show it, where all vertices of the meshes that wear
/// it have alpha `vertex_alpha`; above 1 where none does.
float least_mask_alpha(const scene::Material& material, float vertex_alpha);

} // namespace lambent::draw
