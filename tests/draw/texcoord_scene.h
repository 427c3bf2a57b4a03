// A material whose five textures read five sets of texture coordinates.
#pragma once

#include "tests/draw/test_scenes.h"

#include <array>

namespace lambent::draw::testing {

/// A square from -1 to 1 seen from +Z. Each set of the mesh is elsewhere in one image of 4x4 flat tiles: each texture reads
/// the tile of its own set, and of no other. With `sets` any numbers, the picture is the same.
inline scene::Scene texcoord_scene(const std::array<int, 5>& sets)
{
    scene::Scene scene;
    image::CodeImage tiles{16, 16, 4, 8, {}};
    // Base colour, roughness and metalness, normal, occlusion, emission, each in its own tile of the first row.
    constexpr std::uint8_t codes[5][4] = {
        {200, 90, 40, 255}, {0, 140, 60, 255}, {170, 150, 220, 255}, {90, 0, 0, 255}, {20, 60, 10, 255}};
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            for (int c = 0; c < 4; ++c)
                tiles.bytes.push_back(x / 3 < 5 ? codes[x / 3][c] : std::uint8_t{0});
    scene.images.push_back(tiles);
    scene::Mesh mesh = facing_square(1.0f, 0.0f);
    mesh.texcoords = {};
    scene::Material material;
    material.emissive = glm::vec3(1.0f);
    scene::TextureUse* const uses[] = {&material.base_color_texture, &material.metallic_roughness_texture,
                                       &material.normal_texture, &material.occlusion_texture,
                                       &material.emissive_texture};
    for (std::size_t i = 0; i < 5; ++i) {
        uses[i]->image = 0;
        uses[i]->texcoord = sets[i];
        uses[i]->sampler.magnify_nearest = true;
        const float u = (3.0f * static_cast<float>(i) + 1.5f) / 16.0f;
        mesh.texcoords[sets[i]] = {{u, 0.5f}, {u + 0.01f, 0.5f}, {u + 0.01f, 0.49f}, {u, 0.49f}};
    }
    add(scene, std::move(mesh), material);
    return scene;
}

} // namespace lambent::draw::testing
