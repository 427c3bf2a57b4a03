// The surface pass in SIMD lanes: position, normal and material of hits, by interpolation and textures.
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

/// The distinct sets of texture coordinates that a material's textures read, and the set of each texture.
struct TexcoordChoice {
    TexcoordChoice() = default;
    TexcoordChoice(const scene::Mesh& mesh, const scene::Material& material);

    std::array<const std::vector<glm::vec2>*, scene::texture_count>
        sets{}; ///< the first `count` are used; a set that the mesh lacks is empty
    int count = 0;
    std::array<int, scene::texture_count> of{}; ///< index into `sets`, by texture number

private:
    int add(const scene::Mesh& mesh, const scene::TextureUse& use);
};

/// Data shared by all fragments of a group.
struct SurfaceContext {
    RayMap rays;
    bool met_by_rays =
        false; ///< whether each fragment has its own ray, in the columns met_*, instead of `rays`
    Model model = Model::ggx;
    bool energy_compensation = true;
    const scene::Mesh* mesh = nullptr;
    const scene::Material* material = nullptr;
    MaterialTextures textures{};
    std::array<const scene::TextureUse*, scene::texture_count> uses{};
    std::array<float, scene::texture_count> normal_scales{};
    TexcoordChoice texcoords;
    glm::mat4 transform{1.0f}; ///< world from mesh
    glm::mat3 normals{1.0f};   ///< world from mesh for normals, up to length; outward normals stay outward
    float handedness = 1.0f;   ///< -1 where the transform mirrors
    std::optional<float> roughness; ///< perceptual; replaces the material's
};

/// Fills the surface columns, opacity and emission of the fragments [begin, end) from their positions, hits and
/// triangles. `begin` and `end` are multiples of Fragments::group_alignment.
void find_surfaces(const SurfaceContext& context, std::size_t begin, std::size_t end, Fragments& fragments);

} // namespace lambent::draw
