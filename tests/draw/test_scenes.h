// Small scenes with known answers.
#pragma once

#include "draw/cpu/cpu_renderer.h"
#include "environment/environment.h"
#include "scene/scene.h"
#include "scene/builtin/shapes.h"

#include <glm/ext/matrix_transform.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>

namespace lambent::draw::testing {

/// A square in the plane z = `z`, from -half to half along X and Y, facing +Z, texture upright.
inline scene::Mesh facing_square(float half, float z)
{
    scene::Mesh mesh;
    mesh.positions = {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}};
    mesh.normals.assign(4, {0.0f, 0.0f, 1.0f});
    mesh.tangents.assign(4, {1.0f, 0.0f, 0.0f, 1.0f});
    mesh.texcoords[0] = {{0.0f, 1.0f}, {1.0f, 1.0f}, {1.0f, 0.0f}, {0.0f, 0.0f}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

/// A material without any reflection: what it emits is what is seen.
inline scene::Material glowing(glm::vec3 radiance)
{
    scene::Material material;
    material.base_color = {0.0f, 0.0f, 0.0f, 1.0f};
    material.metallic = 1.0f; // a black metal reflects only at grazing angles, and nothing in darkness
    material.emissive = radiance;
    return material;
}

/// The report's material without a highlight: Schlick's F at grazing keeps Ks = 0 from being quite matte, but seen head
/// on it is.
inline scene::Material matte(glm::vec3 diffuse)
{
    scene::Material material;
    material.phong = scene::PhongMaterial{diffuse, glm::vec3(0.0f), 1.0f};
    return material;
}

inline void add(scene::Scene& scene, scene::Mesh mesh, scene::Material material,
                const glm::mat4& transform = glm::mat4(1.0f))
{
    mesh.material = static_cast<int>(scene.materials.size());
    scene.materials.push_back(std::move(material));
    scene.instances.push_back({static_cast<int>(scene.meshes.size()), -1, transform});
    scene.meshes.push_back(std::move(mesh));
}

/// A camera on the Z axis looking along -Z at `distance` from the origin, seeing `extent` metres from bottom to top.
inline Camera front_camera(float extent, float distance = 10.0f)
{
    Camera camera;
    camera.position = {0.0f, 0.0f, distance};
    camera.vertical_fov = 0.0f;
    camera.vertical_size = extent;
    return camera;
}

inline Settings small_settings(int width, int height, const Camera& camera)
{
    Settings settings;
    settings.width = width;
    settings.height = height;
    settings.camera = camera;
    settings.background.kind = Background::Kind::none;
    return settings;
}

inline environment::Environment environment_of(int width,
                                               const std::function<glm::vec3(glm::dvec3)>& radiance)
{
    image::RadianceImage image{width, width / 2, 3, {}};
    image.values.resize(static_cast<std::size_t>(width * (width / 2)) * 3);
    for (int y = 0; y < width / 2; ++y)
        for (int x = 0; x < width; ++x) {
            const double phi = ((x + 0.5) / width - 0.5) * 2.0 * std::numbers::pi;
            const double theta = (y + 0.5) / width * 2.0 * std::numbers::pi;
            const glm::vec3 c =
                radiance({std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)});
            for (int k = 0; k < 3; ++k)
                image.pixel(x, y)[k] = c[k];
        }
    return environment::make_environment(environment::make_panorama(image));
}

inline environment::Environment white_environment()
{
    return environment_of(64, [](glm::dvec3) { return glm::vec3(1.0f); });
}

inline Frame draw(const scene::Scene& scene, const environment::Environment* environment,
                  const Settings& settings)
{
    return make_cpu_renderer(scene)->draw(environment, settings);
}

inline glm::vec4 pixel(const Frame& frame, int x, int y)
{
    const float* p = frame.radiance.pixel(x, y);
    return {p[0], p[1], p[2], p[3]};
}

/// Throws where there is none: a test of a layer that is not there would pass.
inline const Layer& layer_named(const Frame& frame, std::string_view name)
{
    for (const Layer& layer : frame.layers)
        if (layer.name == name)
            return layer;
    throw std::runtime_error("no layer named " + std::string(name));
}

inline glm::vec3 layer_pixel(const Frame& frame, std::string_view name, int x, int y)
{
    const float* p = layer_named(frame, name).image.pixel(x, y);
    return {p[0], p[1], p[2]};
}

} // namespace lambent::draw::testing
