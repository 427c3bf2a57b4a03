// A material's texture as the shading kernels read it: mip maps with borders, so that any two texels to be filtered
// lie side by side.
#pragma once

#include "draw/settings.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace lambent::draw {

/// RGBA texels, 8 bytes (half floats, linear) or 4 bytes (codes) each. Every level has a border of one texel that
/// holds what the sampler's wrap modes put there.
struct PackedTexture {
    static constexpr int most_levels = 16;

    bool half_floats = false;                     ///< else 8-bit codes
    TexelTransfer transfer = TexelTransfer::none; ///< of 8-bit codes; alpha is always linear
    const float* light = nullptr;                 ///< linear light of each 8-bit code, RGB
    const float* alpha = nullptr;                 ///< the same for alpha
    scene::Sampler sampler;
    int levels = 0;
    std::int32_t width[most_levels] = {};
    std::int32_t height[most_levels] = {};
    std::int32_t start[most_levels] = {}; ///< index of texel (-1, -1)
    std::vector<std::uint8_t> bytes; ///< a few more than the texels need, so that two may be read at the end
};

/// Packs an image for a sampler; the mip maps average linear light. 16-bit codes become half floats. A mask's are packed
/// with the alpha from which on its texels are there: alpha of the first level is the image's, to be held against the
/// cutoff where it is read, that of the others the share of their area that is there.
PackedTexture pack_texture(const image::CodeImage& image, const scene::Sampler& sampler,
                           TexelTransfer transfer, std::optional<float> least_alpha = std::nullopt);

/// Linear light of the 256 codes.
const float* code_light(TexelTransfer transfer);

} // namespace lambent::draw
