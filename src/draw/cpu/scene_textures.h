// A scene's images, packed once for every way in which its materials read them.
#pragma once

#include "draw/cpu/packed_texture.h"
#include "draw/settings.h"
#include "scene/scene.h"

#include <cstddef>
#include <vector>

namespace lambent::draw {

/// A material's textures; null where it has none.
struct MaterialTextures {
    const PackedTexture* base_color = nullptr;
    const PackedTexture* metallic_roughness = nullptr;
    const PackedTexture* normal = nullptr;
    const PackedTexture* occlusion = nullptr;
    const PackedTexture* emissive = nullptr;
};

class SceneTextures {
public:
    /// `transfer`: of colours; everything else is linear.
    SceneTextures(const scene::Scene& scene, TexelTransfer transfer);

    /// The textures of a material of the scene.
    MaterialTextures of(const scene::Material& material) const;

    std::size_t size() const { return textures_.size(); }
    const PackedTexture& operator[](std::size_t i) const { return textures_[i].texture; }

    /// The number of a texture that of() gave; -1 for null.
    int index(const PackedTexture* texture) const;

private:
    const PackedTexture* find(const scene::TextureUse& use, TexelTransfer transfer) const;

    struct Packed {
        int image;
        scene::Sampler sampler;
        TexelTransfer transfer;
        PackedTexture texture;
    };
    TexelTransfer color_;
    std::vector<Packed> textures_;
};

} // namespace lambent::draw
