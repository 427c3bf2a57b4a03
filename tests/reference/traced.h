// Small scenes with known answers, and whether a traced picture agrees with them within its own noise.
#pragma once

#include "reference/tracer.h"
#include "scene/builtin/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace lambent::reference::testing {

using std::numbers::pi;

/// A normal variable is further off than this once in 1.7 million times: the false-alarm rate of one comparison.
constexpr double deviations = 5.0;

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

inline scene::Material metallic(float base, float metalness, float roughness)
{
    scene::Material material;
    material.base_color = {base, base, base, 1.0f};
    material.metallic = metalness;
    material.perceptual_roughness = roughness;
    return material;
}

/// The report's material.
inline scene::Material phong(const glm::vec3& diffuse, const glm::vec3& specular, float exponent)
{
    scene::Material material;
    material.phong = scene::PhongMaterial{diffuse, specular, exponent};
    return material;
}

/// Seen as it is, whatever light there is.
inline scene::Material unlit(const glm::vec3& radiance, float alpha = 1.0f)
{
    scene::Material material;
    material.base_color = glm::vec4(radiance, alpha);
    material.unlit = true;
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

inline scene::Scene scene_of(const scene::Mesh& mesh, const scene::Material& material)
{
    scene::Scene scene;
    add(scene, mesh, material);
    return scene;
}

/// Without perspective, from +Z, seeing `extent` metres from bottom to top around the Z axis.
inline view::Camera front_camera(float extent)
{
    view::Camera camera;
    camera.position = {0.0f, 0.0f, 10.0f};
    camera.vertical_fov = 0.0f;
    camera.vertical_size = extent;
    return camera;
}

inline Settings small_settings(int size, float extent, int samples)
{
    Settings settings;
    settings.width = settings.height = size;
    settings.camera = front_camera(extent);
    settings.background.kind = view::Background::Kind::none;
    settings.samples = samples;
    return settings;
}

/// The panorama of a function of direction, read at the middle of each texel: the middle column is +X, +Z lies a
/// quarter to the right of it, the first row is at +Y.
inline image::RadianceImage panorama_of(int width, const std::function<glm::dvec3(const glm::dvec3&)>& light)
{
    image::RadianceImage image{width, width / 2, 3, {}};
    image.values.resize(static_cast<std::size_t>(width * (width / 2)) * 3);
    for (int y = 0; y < width / 2; ++y)
        for (int x = 0; x < width; ++x) {
            const double phi = ((x + 0.5) / width - 0.5) * 2.0 * pi, theta = (y + 0.5) / width * 2.0 * pi;
            const glm::dvec3 rgb =
                light({std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)});
            for (int c = 0; c < 3; ++c)
                image.pixel(x, y)[c] = static_cast<float>(rgb[c]);
        }
    return image;
}

inline image::RadianceImage white_panorama()
{
    return panorama_of(16, [](const glm::dvec3&) { return glm::dvec3(1.0); });
}

/// Of all pixels of a part of a picture: what they are on average, and the standard deviation of that.
struct Average {
    double mean = 0.0, deviation = 0.0;
};
struct Part {
    int x = 0, y = 0, width = 1, height = 1;
};

inline Part whole(const Result& result)
{
    return {0, 0, result.radiance.width, result.radiance.height};
}

inline Average average(const Result& result, const Part& part, int channel)
{
    double sum = 0.0, variance = 0.0;
    for (int y = part.y; y < part.y + part.height; ++y)
        for (int x = part.x; x < part.x + part.width; ++x) {
            sum += static_cast<double>(result.radiance.pixel(x, y)[channel]);
            if (channel < result.variance.channels) // coverage has none
                variance += static_cast<double>(result.variance.pixel(x, y)[channel]);
        }
    const double count = part.width * part.height;
    return {sum / count, std::sqrt(variance) / count};
}

/// That the picture is what is expected, within its noise and `inexact`, what is known to be left out, relative.
inline void expect_light(const Average& seen, double expected, double inexact = 1e-4)
{
    ASSERT_TRUE(std::isfinite(seen.deviation)) << "one sample tells no noise";
    EXPECT_NEAR(seen.mean, expected, deviations * seen.deviation + inexact * std::fabs(expected))
        << "deviation " << seen.deviation;
}

inline void expect_light(const Result& result, const glm::dvec3& expected, double inexact = 1e-4)
{
    for (int c = 0; c < 3; ++c)
        expect_light(average(result, whole(result), c), expected[c], inexact);
    EXPECT_EQ(result.broken, 0u);
}

} // namespace lambent::reference::testing
