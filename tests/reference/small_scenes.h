// Small scenes and panoramas for the path tracer.
#pragma once

#include "reference/tracer.h"
#include "scene/shapes.h"

#include <glm/ext/matrix_transform.hpp>

#include <cmath>
#include <functional>
#include <numbers>

namespace lambent::reference::testing {

inline void add(scene::Scene& scene, scene::Mesh mesh, scene::Material material,
                const glm::mat4& transform = glm::mat4(1.0f))
{
    mesh.material = static_cast<int>(scene.materials.size());
    scene.materials.push_back(std::move(material));
    scene.instances.push_back({static_cast<int>(scene.meshes.size()), -1, transform});
    scene.meshes.push_back(std::move(mesh));
}

inline scene::Material metallic(glm::vec3 base, float metalness, float roughness)
{
    scene::Material m;
    m.base_color = glm::vec4(base, 1.0f);
    m.metallic = metalness;
    m.perceptual_roughness = roughness;
    return m;
}

/// Reflects nothing at any angle, and shines.
inline scene::Material lamp(glm::vec3 radiance)
{
    scene::Material m;
    m.unlit = true;
    m.base_color = glm::vec4(radiance, 1.0f);
    return m;
}

/// A square in the plane z, from -half to half along X and Y, facing +Z.
inline scene::Mesh facing_square(float half, float z = 0.0f)
{
    scene::Mesh mesh;
    mesh.positions = {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}};
    mesh.normals.assign(4, {0.0f, 0.0f, 1.0f});
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

/// Radiance by direction, at the texels' centres.
inline image::RadianceImage panorama(int width, const std::function<glm::dvec3(glm::dvec3)>& radiance)
{
    image::RadianceImage image{width, width / 2, 3, {}};
    image.values.resize(static_cast<std::size_t>(width * (width / 2)) * 3);
    for (int y = 0; y < width / 2; ++y)
        for (int x = 0; x < width; ++x) {
            const double phi = ((x + 0.5) / width - 0.5) * 2.0 * std::numbers::pi;
            const double theta = (y + 0.5) / (width / 2) * std::numbers::pi;
            const glm::dvec3 c =
                radiance({std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)});
            for (int k = 0; k < 3; ++k)
                image.pixel(x, y)[k] = static_cast<float>(c[k]);
        }
    return image;
}

inline image::RadianceImage white_panorama()
{
    return panorama(16, [](glm::dvec3) { return glm::dvec3(1.0); });
}

/// Looks along -Z from the +Z side, orthographic, `extent` metres from bottom to top.
inline Settings front_view(int size, float extent, int samples)
{
    Settings settings;
    settings.width = settings.height = size;
    settings.camera.position = {0.0f, 0.0f, 10.0f};
    settings.camera.vertical_fov = 0.0f;
    settings.camera.vertical_size = extent;
    settings.background.kind = view::Background::Kind::none;
    settings.samples = samples;
    return settings;
}

/// Mean of a channel over all pixels, and its standard error by the tracer's own variances.
struct Mean {
    double value = 0.0, error = 0.0;
};
inline Mean mean_of(const Result& result, int channel = 0)
{
    Mean m;
    double variance = 0.0, pixels = 0.0;
    for (int y = 0; y < result.radiance.height; ++y)
        for (int x = 0; x < result.radiance.width; ++x, ++pixels) {
            m.value += static_cast<double>(result.radiance.pixel(x, y)[channel]);
            variance += static_cast<double>(result.variance.pixel(x, y)[channel]);
        }
    m.value /= pixels;
    m.error = std::sqrt(variance) / pixels;
    return m;
}

/// Further from 0 than this a standard normal is once in 5 million.
constexpr double most_sigmas = 5.2;

} // namespace lambent::reference::testing
