// A scene's images, packed once for every combination of sampler, transfer and mask by which materials read them.
#pragma once

#include "draw/textures/packed_texture.h"
#include "draw/settings.h"
#include "scene/scene.h"

#include <cstddef>
#include <array>
#include <optional>
#include <vector>

namespace lambent::draw {

/// A material's textures by number (shading/material/textures.h); null where it has none.
using MaterialTextures = std::array<const PackedTexture*, scene::texture_count>;

class SceneTextures {
public:
    /// `color` is the transfer of colour textures; all others are linear.
    SceneTextures(const scene::Scene& scene, TexelTransfer color);

    /// The textures of the material with this index.
    MaterialTextures of(std::size_t material) const { return materials_[material]; }

    std::size_t size() const { return textures_.size(); }
    const PackedTexture& operator[](std::size_t i) const { return textures_[i].texture; }

    /// The index of a texture that of() returned; -1 for null.
    int index(const PackedTexture* texture) const;

private:
    /// An image packed for one such combination.
    struct Packed {
        int image;
        scene::Sampler sampler;
        TexelTransfer transfer;
        std::optional<float> least_alpha; ///< for masks, see pack_texture
        PackedTexture texture;
    };
    void list_textures(const scene::Scene& scene, TexelTransfer color);
    void add(const scene::TextureUse& use, TexelTransfer transfer, std::optional<float> least_alpha);
    const PackedTexture* find(const scene::TextureUse& use, TexelTransfer transfer,
                              std::optional<float> least_alpha) const;

    std::vector<Packed> textures_;
    std::vector<MaterialTextures> materials_;
};

} // namespace lambent::draw
