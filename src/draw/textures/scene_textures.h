// A scene's images, packed once for every way in which its materials read them.
#pragma once

#include "draw/textures/packed_texture.h"
#include "draw/settings.h"
#include "scene/scene.h"

#include <cstddef>
#include <array>
#include <optional>
#include <vector>

namespace lambent::draw {

/// A material's textures by their numbers (shading/material/textures.h); null where it has none.
using MaterialTextures = std::array<const PackedTexture*, scene::texture_count>;

class SceneTextures {
public:
    /// `color`: the transfer of colours; everything else is linear.
    SceneTextures(const scene::Scene& scene, TexelTransfer color);

    /// The textures of a material of the scene, by its number.
    MaterialTextures of(std::size_t material) const { return materials_[material]; }

    std::size_t size() const { return textures_.size(); }
    const PackedTexture& operator[](std::size_t i) const { return textures_[i].texture; }

    /// The number of a texture that of() gave; -1 for null.
    int index(const PackedTexture* texture) const;

private:
    /// One way of reading an image.
    struct Packed {
        int image;
        scene::Sampler sampler;
        TexelTransfer transfer;
        std::optional<float> least_alpha; ///< of masks, as pack_texture has it
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
