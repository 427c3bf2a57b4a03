// Lights without size, and what surfaces do that need no environment, against closed forms.
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambent::draw {
namespace {

using testing::matte;
using testing::pixel;

scene::Scene square_of(scene::Material material)
{
    scene::Scene scene;
    testing::add(scene, testing::facing_square(1.0f, 0.0f), std::move(material));
    return scene;
}

Settings phong_settings(int size)
{
    Settings settings = testing::small_settings(size, size, testing::front_camera(1.0f));
    settings.model = Model::phong;
    return settings;
}

TEST(Lights, DirectionalLightOnAMatteSurface)
{
    Settings settings = phong_settings(5);
    scene::Light light;
    light.kind = scene::LightKind::directional;
    light.direction = {0.0f, 0.0f, -1.0f};
    light.intensity = {3.0f, 2.0f, 1.0f};
    settings.lights = {light};
    const Frame frame = testing::draw(square_of(matte({0.5f, 0.25f, 1.0f})), nullptr, settings);
    const glm::vec4 seen = pixel(frame, 2, 2);
    EXPECT_NEAR(seen.r, 0.5 * 3.0 / std::numbers::pi, 1e-5);
    EXPECT_NEAR(seen.g, 0.25 * 2.0 / std::numbers::pi, 1e-5);
    EXPECT_NEAR(seen.b, 1.0 * 1.0 / std::numbers::pi, 1e-5);
    EXPECT_EQ(seen.a, 1.0f);
}

TEST(Lights, PointLightFallsWithTheSquareOfTheDistance)
{
    for (double distance : {0.5, 1.0, 4.0}) {
        Settings settings = phong_settings(5);
        scene::Light light;
        light.position = {0.0f, 0.0f, static_cast<float>(distance)};
        light.intensity = glm::vec3(10.0f);
        settings.lights = {light};
        const Frame frame = testing::draw(square_of(matte(glm::vec3(1.0f))), nullptr, settings);
        EXPECT_NEAR(pixel(frame, 2, 2).r, 10.0 / (distance * distance) / std::numbers::pi, 1e-3 / distance);
    }
}

TEST(Lights, PointLightEndsAtItsRange)
{
    Settings settings = phong_settings(5);
    scene::Light light;
    light.position = {0.0f, 0.0f, 2.0f};
    light.range = 1.9f;
    settings.lights = {light};
    EXPECT_EQ(pixel(testing::draw(square_of(matte(glm::vec3(1.0f))), nullptr, settings), 2, 2).r, 0.0f);
}

TEST(Lights, SpotLightsOnlyItsCone)
{
    Settings settings = phong_settings(101);
    settings.camera.vertical_size = 2.0f;
    scene::Light light;
    light.kind = scene::LightKind::spot;
    light.position = {0.0f, 0.0f, 1.0f};
    light.direction = {0.0f, 0.0f, -1.0f};
    light.inner_cone = 0.2f;
    light.outer_cone = 0.4f;
    settings.lights = {light};
    const Frame frame = testing::draw(square_of(matte(glm::vec3(1.0f))), nullptr, settings);
    EXPECT_NEAR(pixel(frame, 50, 50).r, 1.0 / std::numbers::pi, 1e-3);
    const int inside = 50 + static_cast<int>(std::tan(0.38) * 50),
              outside = 50 + static_cast<int>(std::tan(0.43) * 50);
    EXPECT_GT(pixel(frame, inside, 50).r, 0.0f);
    EXPECT_EQ(pixel(frame, outside, 50).r, 0.0f);
}

// At L = V = N: D = (alpha + 2) / (2 pi), F = Ks, and the masking term is 1 / 4.
TEST(Lights, PhongHighlightHeadOn)
{
    scene::Material glossy;
    glossy.phong = scene::PhongMaterial{glm::vec3(0.0f), glm::vec3(0.3f, 0.6f, 0.9f), 20.0f};
    Settings settings = phong_settings(5);
    scene::Light light;
    light.kind = scene::LightKind::directional;
    light.direction = {0.0f, 0.0f, -1.0f};
    settings.lights = {light};
    const glm::vec4 seen = pixel(testing::draw(square_of(glossy), nullptr, settings), 2, 2);
    const double peak = 22.0 / (2.0 * std::numbers::pi) / 4.0;
    EXPECT_NEAR(seen.r, 0.3 * peak, 1e-4);
    EXPECT_NEAR(seen.g, 0.6 * peak, 1e-4);
    EXPECT_NEAR(seen.b, 0.9 * peak, 1e-4);
}

TEST(Lights, EmissionAndUnlitNeedNoLight)
{
    const Settings settings = testing::small_settings(5, 5, testing::front_camera(1.0f));
    EXPECT_NEAR(
        pixel(testing::draw(square_of(testing::glowing({0.25f, 3.0f, 70.0f})), nullptr, settings), 2, 2).b,
        70.0f, 1e-3f);
    scene::Material unlit;
    unlit.unlit = true;
    unlit.base_color = {0.5f, 0.25f, 0.125f, 1.0f};
    const environment::Environment white = testing::white_environment();
    const glm::vec4 seen = pixel(testing::draw(square_of(unlit), &white, settings), 2, 2);
    EXPECT_NEAR(seen.r, 0.5f, 1e-6f);
    EXPECT_NEAR(seen.b, 0.125f, 1e-6f);
}

TEST(Lights, AmbientLightOfAWhiteSphereOnAMatteSurface)
{
    Settings settings = phong_settings(5);
    settings.ambient_brightness = 2.0f;
    settings.layers = true;
    const environment::Environment white = testing::white_environment();
    const Frame frame = testing::draw(square_of(matte({0.5f, 0.25f, 0.75f})), &white, settings);
    // Kd / pi * irradiance pi * brightness
    EXPECT_NEAR(testing::layer_pixel(frame, "light_ambient", 2, 2).b, 2.0f * 0.75f, 2e-3f);
}

TEST(Lights, LayersOfLightAddUpToThePicture)
{
    scene::Scene scene;
    testing::add(scene, scene::make_sphere(0.4f, 32, 16), scene::Material{});
    scene.materials[0].emissive = {0.1f, 0.0f, 0.2f};
    scene.materials[0].metallic = 0.4f;
    scene.materials[0].perceptual_roughness = 0.4f;
    for (Model model : {Model::ggx, Model::phong}) {
        Settings settings = testing::small_settings(40, 30, testing::front_camera(1.0f));
        settings.model = model;
        settings.background.kind = Background::Kind::environment;
        settings.layers = true;
        settings.lights = {scene::Light{}};
        settings.lights[0].position = {1.0f, 1.0f, 2.0f};
        const environment::Environment environment = testing::environment_of(
            128, [](glm::dvec3 d) { return glm::vec3(1.0 + d.y, 1.0 + 0.5 * d.x, 0.7); });
        const Frame frame = testing::draw(scene, &environment, settings);
        for (std::size_t i = 0; i < frame.radiance.values.size(); ++i) {
            if (i % 4 == 3)
                continue;
            float sum = 0.0f;
            for (const Layer& layer : frame.layers)
                if (layer.kind == Layer::Kind::light)
                    sum += layer.image.values[i];
            ASSERT_NEAR(sum, frame.radiance.values[i], 1e-5f);
        }
    }
}

} // namespace
} // namespace lambent::draw
