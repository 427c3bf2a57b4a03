// The opaque share of a mask's texels, which coarser mip levels keep.
#pragma once

#include "scene/scene.h"

namespace lambent::draw {

/// Alpha of a texel, [1][1], and of its eight neighbours, by rows.
struct AlphaAround {
    float alpha[3][3];
};

/// Share of the texel's area, 0 to 1, where alpha is at least `least` under magnification: bilinear between the
/// centres of texels, or, if `in_blocks`, constant over each texel. Exact along rows, of which eight are summed.
float covered_share(const AlphaAround& around, float least, bool in_blocks);

/// The least alpha of a material's base colour texture that its mask shows, if all vertices of its meshes have alpha
/// `vertex_alpha`; above 1 if the mask shows none.
float least_mask_alpha(const scene::Material& material, float vertex_alpha);

} // namespace lambent::draw
