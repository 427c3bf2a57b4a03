// A scene whose every part moves.
#pragma once

#include "tests/draw/test_scenes.h"

#include <glm/ext/matrix_transform.hpp>

namespace lambent::draw::testing {

/// A textured square that moves and becomes mirrored, a sphere shown twice that is deformed, a lamp that moves; `moment`
/// from 0 to 1.
inline scene::Scene pose_scene(float moment)
{
    scene::Scene scene;
    image::CodeImage chart;
    chart.width = chart.height = 2;
    chart.channels = 4;
    chart.bytes = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 90, 90, 90, 255};
    scene.images.push_back(chart);
    scene::Material painted;
    painted.metallic = 0.0f;
    painted.base_color_texture.image = 0;
    painted.double_sided = true;
    const float side = moment > 0.5f ? -0.8f : 0.8f;
    add(scene, facing_square(0.6f, 0.0f), painted,
        glm::scale(glm::translate(glm::mat4(1.0f), {0.4f - moment, 0.0f, -0.5f}), {side, 0.9f, 1.0f}));
    scene::Mesh sphere = scene::make_sphere(1.0f, 24, 12);
    for (glm::vec3& position : sphere.positions)
        position *= glm::vec3(0.3f, 0.3f + 0.2f * moment, 0.3f);
    scene::Material matt;
    matt.metallic = 0.0f;
    add(scene, std::move(sphere), matt, glm::translate(glm::mat4(1.0f), {-0.5f, 0.3f * moment, 0.4f}));
    scene.instances.push_back({1, -1, glm::translate(glm::mat4(1.0f), {0.5f, -0.4f * moment, 0.2f})});
    scene::Light lamp;
    lamp.position = {moment, 1.0f, 2.0f};
    lamp.intensity = {3.0f, 2.0f, 1.0f};
    scene.lights.push_back(lamp);
    return scene;
}

inline Settings pose_settings()
{
    Settings settings = small_settings(64, 48, front_camera(2.2f));
    settings.samples = 8;
    return settings;
}

} // namespace lambent::draw::testing
