// Scenes of points and lines.
#pragma once

#include "tests/draw/test_scenes.h"

#include <glm/geometric.hpp>

#include <vector>

namespace lambent::draw::testing {

/// Of points and lines without normals, as the loader has it.
inline scene::Material line_material(glm::vec3 color)
{
    scene::Material material;
    material.base_color = glm::vec4(color, 1.0f);
    material.unlit = true;
    material.double_sided = true;
    return material;
}

inline scene::Mesh line(glm::vec3 from, glm::vec3 to)
{
    scene::Mesh mesh;
    mesh.positions = {from, to};
    mesh.lines = {{0, 1}};
    return mesh;
}

inline scene::Mesh points(std::vector<glm::vec3> positions)
{
    scene::Mesh mesh;
    mesh.positions = std::move(positions);
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i)
        mesh.points.push_back(i);
    return mesh;
}

inline scene::Scene scene_of(scene::Mesh mesh, const scene::Material& material)
{
    scene::Scene scene;
    add(scene, std::move(mesh), material);
    return scene;
}

/// A picture in which a metre is a pixel: (x, y) pixels to the right and down from the middle is the world's (x, -y).
inline Settings pixel_settings(int width, int height)
{
    return small_settings(width, height, front_camera(static_cast<float>(height)));
}

/// A camera like no other: all it has is odd.
inline Camera odd_camera()
{
    Camera camera;
    camera.position = {3.0f, -2.0f, 5.0f};
    camera.back = glm::normalize(glm::vec3(0.5f, -0.3f, 1.0f));
    camera.right = glm::normalize(glm::cross(glm::vec3(0.2f, 1.0f, 0.1f), camera.back));
    camera.up = glm::cross(camera.back, camera.right);
    camera.vertical_fov = 0.9f;
    return camera;
}

/// All coverage of a picture, in pixels.
inline double covered(const image::RadianceImage& picture)
{
    double sum = 0.0;
    for (std::size_t i = 3; i < picture.values.size(); i += 4)
        sum += static_cast<double>(picture.values[i]);
    return sum;
}

} // namespace lambent::draw::testing
