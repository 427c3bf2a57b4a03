// Materials of surfaces, and their textures.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace lambent::scene {

enum class Wrap : std::uint8_t { repeat, mirrored_repeat, clamp_to_edge };

/// How a texture is read outside [0, 1] and between texels. [glTF 2.0, 3.8.4]
struct Sampler {
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
    bool magnify_nearest = false; ///< magFilter NEAREST
    bool minify_nearest = false;  ///< minFilter NEAREST or NEAREST_MIPMAP_*
    bool nearest_mipmap = false;  ///< minFilter *_MIPMAP_NEAREST: one mip map is read, not a blend of two
    bool mipmapped = true;        ///< minFilter uses mip maps, or is absent

    bool operator==(const Sampler&) const = default;
};

/// One use of an image by a material.
struct TextureUse {
    int image = -1; ///< index into Scene::images; -1: no texture
    Sampler sampler;
    int texcoord = 0;          ///< number of the mesh's set of texture coordinates, not below 0
    glm::mat3 transform{1.0f}; ///< applied to (u, v, 1); KHR_texture_transform
};

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

/// Parameters of the report's Phong model. Those that are set replace the values derived from the material's colour,
/// metalness and roughness.
struct PhongMaterial {
    std::optional<glm::vec3> diffuse;  ///< Kd
    std::optional<glm::vec3> specular; ///< Ks
    std::optional<float> exponent;     ///< alpha of the report: Phong exponent, 0 < exponent <= 1e6
};

/// A metallic-roughness material. [glTF 2.0, 3.9] Its factors and textures are the rows of shading/material/;
/// `emissive` is radiance in nits and includes KHR_materials_emissive_strength.
struct Material {
    std::string name;
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture) glm::vec4 name{value};
#define COLOR(name, number, value, object, key, texture) glm::vec3 name{value};
#define SCALAR(name, number, value, object, key, texture, channel) float name = value;
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel) float factor = value;
#define STRENGTH(name, factor, number, value, object, key, texture, channel) float factor = value;
#include "shading/material/parameters.h"
#define TEXTURE(name, number, transfer, object, key) TextureUse name##_texture;
#define NORMAL_TEXTURE(name, number, object, key)                                                            \
    TextureUse name##_texture;                                                                               \
    float name##_scale = 1.0f;
#include "shading/material/textures.h"
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    bool unlit = false; ///< KHR_materials_unlit: base colour is the radiance
    PhongMaterial phong;
};

#include "shading/material/numbers.glsl"

/// Whether the codes of a texture are colours, with a transfer function, or linear numbers.
enum class TextureCodes : std::uint8_t { color, linear };

/// Calls visit(number, use, codes) for every texture of a material, also for those without an image.
template <class SomeMaterial, class Visit>
void for_each_texture(SomeMaterial& material, const Visit& visit)
{
#define TEXTURE(name, number, transfer, object, key)                                                         \
    visit(texture_##name, material.name##_texture, TextureCodes::transfer);
#define NORMAL_TEXTURE(name, number, object, key)                                                            \
    visit(texture_##name, material.name##_texture, TextureCodes::linear);
#include "shading/material/textures.h"
}

/// Whether the material may have a lobe over its base (shading/lobes/layers.h).
bool has_layers(const Material& material);

/// The material's factors, indexed by the numbers of the parameters.
std::array<float, parameter_numbers> factors_of(const Material& material);

/// The scales of the material's normal maps, indexed by the numbers of the textures; 1 for other textures.
std::array<float, texture_count> normal_scales_of(const Material& material);

} // namespace lambent::scene
