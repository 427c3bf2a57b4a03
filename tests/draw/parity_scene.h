// A scene that uses every texture slot, every kind of sampler, mirrored instances, every alpha mode, colours of vertices and
// both sets of coordinates: what two backends draw alike, they read alike.
#pragma once

#include "tests/draw/test_scenes.h"

#include "scene/tangents.h"

#include <random>

namespace lambent::draw::testing {

/// A soft pattern, of which no texel is its neighbour's like: of how many reads a footprint is made is not the same everywhere.
inline image::CodeImage soft_pattern(int width, int height, int seed, int low, int bits)
{
    image::CodeImage image{width, height, 4, bits, {}};
    std::mt19937 random(static_cast<unsigned>(seed));
    std::uniform_int_distribution<int> code(low, 255);
    for (int i = 0; i < 4 * width * height; ++i) {
        if (bits == 16)
            image.bytes.push_back(static_cast<std::uint8_t>(code(random)));
        image.bytes.push_back(static_cast<std::uint8_t>(code(random)));
    }
    return image;
}

/// Normals that lean by up to seven degrees along each side.
inline image::CodeImage bumps(int size)
{
    image::CodeImage image = soft_pattern(size, size, 9, 0, 8);
    for (std::size_t i = 0; i < image.bytes.size(); i += 4) {
        for (std::size_t c = 0; c < 2; ++c)
            image.bytes[i + c] = static_cast<std::uint8_t>(112 + image.bytes[i + c] / 8);
        image.bytes[i + 2] = 250;
    }
    return image;
}

inline scene::Mesh painted_ball()
{
    scene::Mesh mesh = scene::make_sphere(0.3f, 48, 24);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        mesh.texcoords[1].push_back({0.4f * mesh.positions[i].x + 0.3f, 0.7f - 0.5f * mesh.positions[i].y});
        const glm::vec3 place = mesh.positions[i] / 0.3f;
        mesh.colors.emplace_back(0.75f + 0.25f * place, 0.8f + 0.2f * place.y);
    }
    scene::make_tangents(mesh, 0, glm::mat3(1.0f));
    return mesh;
}

/// The material of ball `i`: all slots, each with its sampler.
inline scene::Material painted_material(int i)
{
    using scene::Wrap;
    constexpr Wrap wraps[] = {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge};
    scene::Material m;
    for_each_texture(m, [&](int slot, scene::TextureUse& use, scene::TextureCodes) {
        const int kind = i + slot;
        use.image = slot;
        use.texcoord = kind % 2;
        use.sampler = {wraps[kind % 3], wraps[(kind / 2) % 3], kind % 4 == 1,
                       kind % 4 == 2,   kind % 5 == 3,         kind % 6 != 4};
        const float turn = 0.3f * static_cast<float>(kind),
                    stretch = 0.8f + 0.5f * static_cast<float>(kind % 3);
        use.transform = glm::mat3(stretch * std::cos(turn), -stretch * std::sin(turn), 0.0f, std::sin(turn),
                                  std::cos(turn), 0.0f, -0.2f * static_cast<float>(kind), 0.1f, 1.0f);
    });
    m.base_color = {0.9f, 0.8f, 0.7f, 0.8f};
    m.metallic = 0.6f;
    m.perceptual_roughness = 0.7f;
    m.emissive = {0.2f, 0.15f, 0.1f};
    m.normal_scale = 0.8f;
    m.occlusion_strength = 0.7f;
    m.coat = i % 3 == 1 ? 0.9f : 0.0f;
    m.coat_roughness = 0.3f;
    m.coat_normal_scale = 0.6f;
    m.alpha_mode = static_cast<scene::AlphaMode>(i % 3);
    // Nothing is seen through holes of balls whose insides show: rounding may decide for either side of the edge of a hole.
    m.alpha_cutoff = i % 2 == 1 ? 0.05f : 0.55f;
    m.double_sided = i % 2 == 1;
    return m;
}

/// Twelve balls, every other mirrored, stretched and turned.
inline scene::Scene parity_scene()
{
    scene::Scene scene;
    scene.images = {soft_pattern(13, 8, 1, 190, 16),
                    soft_pattern(16, 16, 2, 190, 8),
                    bumps(24),
                    soft_pattern(9, 9, 4, 190, 8),
                    soft_pattern(32, 5, 5, 190, 8),
                    soft_pattern(8, 12, 6, 60, 8),
                    soft_pattern(7, 9, 7, 60, 8),
                    bumps(17)};
    const scene::Mesh ball = painted_ball();
    for (int i = 0; i < 12; ++i) {
        const glm::vec3 place(0.75f * static_cast<float>(i % 4), 0.75f * static_cast<float>(i / 4),
                              0.1f * static_cast<float>(i % 5));
        const glm::mat4 moved = glm::rotate(glm::translate(glm::mat4(1.0f), place),
                                            0.5f * static_cast<float>(i), glm::vec3(0.3f, 1.0f, 0.2f));
        add(scene, ball, painted_material(i), glm::scale(moved, {i % 2 == 0 ? 1.0f : -0.9f, 1.1f, 0.9f}));
    }
    return scene;
}

} // namespace lambent::draw::testing
