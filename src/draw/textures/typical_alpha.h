// How smooth a material is, for the decision how many points of a pixel are shaded.
#pragma once

#include "draw/settings.h"
#include "draw/textures/scene_textures.h"
#include "scene/scene.h"

namespace lambent::draw {

/// The alpha of a material's narrowest lobe by each shading model, with roughness textures replaced by their means.
struct TypicalAlpha {
    float ggx = 1.0f, phong = 1.0f;

    TypicalAlpha() = default;
    TypicalAlpha(const scene::Material& material, const MaterialTextures& textures);

    /// The one of a picture's model, or that of the roughness which the picture sets for all surfaces.
    float in(const Settings& settings) const;
};

/// The mean of a texture's texels, linear; 1 without a texture. Reads at most 4096 texels of the coarsest level.
glm::vec4 mean_texel(const PackedTexture* texture);

} // namespace lambent::draw
