// From hits to surfaces: position, normal, material, by interpolation and textures, on SIMD lanes.
#pragma once

#include "draw/settings.h"
#include "draw/cpu/fragments.h"
#include "draw/textures/scene_textures.h"
#include "scene/scene.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <optional>
#include <vector>

namespace lambent::draw {

/// The sets of texture coordinates that a material's textures read, each once, and which of these each texture reads.
struct TexcoordChoice {
    TexcoordChoice() = default;
    TexcoordChoice(const scene::Mesh& mesh, const scene::Material& material);

    std::array<const std::vector<glm::vec2>*, scene::texture_count>
        sets{}; ///< the first `count`; empty where the mesh has none such
    int count = 0;
    std::array<int, scene::texture_count> of{}; ///< by the textures' numbers, index into sets

private:
    int add(const scene::Mesh& mesh, const scene::TextureUse& use);
};

/// What all fragments of a group share.
struct SurfaceContext {
    RayMap rays;
    Model model = Model::ggx;
    bool energy_compensation = true;
    const scene::Mesh* mesh = nullptr;
    const scene::Material* material = nullptr;
    MaterialTextures textures{};
    std::array<const scene::TextureUse*, scene::texture_count> uses{};
    std::array<float, scene::texture_count> normal_scales{};
    TexcoordChoice texcoords;
    glm::mat4 transform{1.0f}; ///< world from mesh
    glm::mat3 normals{1.0f};   ///< world from mesh for normals, up to length; keeps what is outside outside
    float handedness = 1.0f;   ///< -1 where the transform mirrors
    std::optional<float> roughness; ///< perceptual, instead of the material's
};

/// Fills the surface columns, `opacity` and `emitted_*` of the fragments [begin, end), multiples of
/// Fragments::group_alignment, from place, hit_* and triangle.
void find_surfaces(const SurfaceContext& context, std::size_t begin, std::size_t end, Fragments& fragments);

} // namespace lambent::draw
