// A scene with all that does not change from picture to picture worked out.
#pragma once

#include "draw/cpu/light_kernel.h"
#include "draw/cpu/packed_texture.h"
#include "draw/cpu/surface_kernel.h"
#include "trace/visibility.h"
#include "scene/scene.h"

#include <span>
#include <vector>

namespace lambent::draw {

using trace::Visibility;

class PreparedScene {
public:
    /// The scene must outlive it.
    PreparedScene(const scene::Scene& scene, TexelTransfer transfer);

    const Visibility& visibility() const { return visibility_; }

    /// What the surfaces of an instance share; rays and model are left to the caller.
    const SurfaceContext& surface(std::uint32_t instance) const { return surfaces_[instance]; }

    /// Whether a ray that meets the back of this instance goes on.
    bool culls_back(std::uint32_t instance) const { return !surfaces_[instance].material->double_sided; }

private:
    const PackedTexture* texture(const scene::TextureUse& use, TexelTransfer transfer) const;
    void pack_textures(TexelTransfer color);

    struct Packed {
        int image;
        scene::Sampler sampler;
        TexelTransfer transfer;
        PackedTexture texture;
    };

    const scene::Scene& scene_;
    Visibility visibility_;
    std::vector<Packed> textures_; ///< each image once for every way of reading it
    std::vector<SurfaceContext> surfaces_;
};

/// The scene's lights and `more`, as the kernel wants them.
std::vector<LightSource> light_sources(std::span<const scene::Light> lights,
                                       std::span<const scene::Light> more);

} // namespace lambent::draw
