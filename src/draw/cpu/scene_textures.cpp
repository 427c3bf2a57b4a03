#include "draw/cpu/scene_textures.h"

#include <tbb/parallel_for.h>

namespace lambent::draw {

SceneTextures::SceneTextures(const scene::Scene& scene, TexelTransfer transfer) : color_(transfer)
{
    const auto add = [&](const scene::TextureUse& use, TexelTransfer by) {
        if (use.image >= 0 && !find(use, by))
            textures_.push_back({use.image, use.sampler, by, {}});
    };
    for (const scene::Material& m : scene.materials) {
        add(m.base_color_texture, color_);
        add(m.metallic_roughness_texture, TexelTransfer::none);
        add(m.normal_texture, TexelTransfer::none);
        add(m.occlusion_texture, TexelTransfer::none);
        add(m.emissive_texture, color_);
    }
    tbb::parallel_for(std::size_t{0}, textures_.size(), [&](std::size_t i) {
        Packed& packed = textures_[i];
        packed.texture = pack_texture(scene.images[static_cast<std::size_t>(packed.image)], packed.sampler,
                                      packed.transfer);
    });
}

const PackedTexture* SceneTextures::find(const scene::TextureUse& use, TexelTransfer transfer) const
{
    for (const Packed& packed : textures_)
        if (packed.image == use.image && packed.transfer == transfer && packed.sampler == use.sampler)
            return &packed.texture;
    return nullptr;
}

MaterialTextures SceneTextures::of(const scene::Material& m) const
{
    return {find(m.base_color_texture, color_), find(m.metallic_roughness_texture, TexelTransfer::none),
            find(m.normal_texture, TexelTransfer::none), find(m.occlusion_texture, TexelTransfer::none),
            find(m.emissive_texture, color_)};
}

int SceneTextures::index(const PackedTexture* texture) const
{
    for (std::size_t i = 0; i < textures_.size(); ++i)
        if (&textures_[i].texture == texture)
            return static_cast<int>(i);
    return -1;
}

} // namespace lambent::draw
