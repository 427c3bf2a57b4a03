// One roughness for all surfaces: the picture of a scene whose materials have it.
#include "scene/builtin/builtin.h"
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

namespace lambent::draw {
namespace {

// Without textures of it.
scene::Scene with_roughness(scene::Scene scene, float roughness)
{
    for (scene::Material& material : scene.materials) {
        material.perceptual_roughness = roughness;
        material.metallic_roughness_texture = {};
    }
    return scene;
}

// A square whose texture of roughness goes up and down.
scene::Scene textured_square()
{
    scene::Material material;
    material.base_color = {0.8f, 0.5f, 0.2f, 1.0f};
    material.metallic = 0.0f;
    material.perceptual_roughness = 0.9f;
    material.metallic_roughness_texture.image = 0;
    scene::Scene scene;
    testing::add(scene, testing::facing_square(1.0f, 0.0f), material);
    scene.images.push_back({2, 2, 4, 8, {0, 30, 255, 255, 0, 250, 80, 255, 0, 140, 0, 255, 0, 90, 7, 255}});
    return scene;
}

void expect_same_picture(const scene::Scene& scene, Settings settings)
{
    const environment::Environment light = testing::environment_of(
        64, [](glm::dvec3 d) { return glm::vec3(1.5 + d.x, 1.5 + d.y * d.z, 1.5 - d.z); });
    settings.lights.push_back({});
    settings.lights[0].position = {0.5f, 1.0f, 3.0f};
    const image::RadianceImage own = testing::draw(scene, &light, settings).radiance;
    for (const float roughness : {0.0f, 0.3f, 1.0f}) {
        settings.roughness_override.reset();
        const Frame wanted = testing::draw(with_roughness(scene, roughness), &light, settings);
        settings.roughness_override = roughness;
        const Frame found = testing::draw(scene, &light, settings);
        EXPECT_EQ(found.radiance.values, wanted.radiance.values) << roughness;
        EXPECT_NE(found.radiance.values, own.values) << roughness;
    }
}

TEST(Roughness, OfAllSurfacesIsThatOfTheirMaterials)
{
    const scene::Scene grid = scene::make_builtin("grid");
    Settings settings = testing::small_settings(64, 36, {});
    settings.camera = orbit_camera(scene::bounds(grid), {0.4f, 0.3f, 0.0f}, 0.7f, 16.0f / 9.0f);
    expect_same_picture(grid, settings);
    expect_same_picture(textured_square(), testing::small_settings(24, 24, testing::front_camera(1.5f)));
}

} // namespace
} // namespace lambent::draw
