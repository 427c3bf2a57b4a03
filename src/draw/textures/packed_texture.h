// A material's texture as the shading kernels read it: mip maps with borders, so that any two neighbouring texels that
// are filtered together are adjacent in memory.
#pragma once

#include "draw/settings.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace lambent::draw {

/// RGBA texels, 8 bytes (half floats, linear) or 4 bytes (codes) each. Every level has a border of one texel, which
/// continues it by the sampler's wrap modes.
struct PackedTexture {
    static constexpr int most_levels = 16;

    bool half_floats = false;                     ///< if false, 8-bit codes
    TexelTransfer transfer = TexelTransfer::none; ///< of 8-bit codes; alpha is always linear
    const float* light = nullptr;                 ///< linear light of each 8-bit code, RGB
    const float* alpha = nullptr;                 ///< the same for alpha
    scene::Sampler sampler;
    int levels = 0;
    std::int32_t width[most_levels] = {};
    std::int32_t height[most_levels] = {};
    std::int32_t start[most_levels] = {}; ///< index of texel (-1, -1)
    std::vector<std::uint8_t> bytes;      ///< 16 more than the texels need, because texels are read in pairs
};

/// Packs an image for a sampler; the mip maps average linear light. 16-bit codes become half floats. For a mask,
/// `least_alpha` is the least alpha of opaque texels: the first level keeps the image's alpha, which is compared with
/// the cutoff when it is read; alpha of the other levels is the opaque share of a texel's area.
PackedTexture pack_texture(const image::CodeImage& image, const scene::Sampler& sampler,
                           TexelTransfer transfer, std::optional<float> least_alpha = std::nullopt);

/// Table of the linear light of all 256 codes.
const float* code_light(TexelTransfer transfer);

} // namespace lambent::draw
