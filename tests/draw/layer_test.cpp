// The layers of the G-buffer and of the light, each by its name.
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambent::draw {
namespace {

using std::numbers::pi;
using testing::layer_pixel;

Frame draw_layers(const scene::Material& material, Settings settings,
                  const environment::Environment* environment = nullptr)
{
    scene::Scene scene;
    testing::add(scene, testing::facing_square(4.0f, 0.0f), material);
    scene.images.push_back({1, 1, 4, 8, {51, 0, 0, 255}}); // 51 is a fifth
    settings.layers = true;
    return testing::draw(scene, environment, settings);
}

TEST(Layers, AreAllThere)
{
    const Settings settings = testing::small_settings(3, 3, testing::front_camera(1.0f));
    const Frame frame = draw_layers({}, settings);
    for (const char* name :
         {"base_color", "specular", "alpha", "metalness", "normal", "depth", "occlusion", "irradiance",
          "light_emitted", "light_direct", "light_ambient", "light_specular", "light_background"})
        EXPECT_NO_THROW(testing::layer_named(frame, name)) << name;
    EXPECT_THROW(testing::layer_named(frame, "exponent"), std::runtime_error);
    Settings phong = settings;
    phong.model = Model::phong;
    EXPECT_NO_THROW(testing::layer_named(draw_layers({}, phong), "exponent"));
    EXPECT_NO_THROW(testing::layer_named(draw_layers({}, phong), "diffuse"));
}

TEST(Layers, DepthIsInMetresFromTheCamera)
{
    const Settings settings = testing::small_settings(5, 5, testing::front_camera(1.0f, 10.0f));
    EXPECT_NEAR(layer_pixel(draw_layers({}, settings), "depth", 0, 3).r, 10.0f, 1e-4f);
    Camera perspective = testing::front_camera(1.0f, 10.0f);
    perspective.vertical_fov = 0.6f;
    const Frame frame = draw_layers({}, testing::small_settings(5, 5, perspective));
    EXPECT_NEAR(layer_pixel(frame, "depth", 2, 2).g, 10.0f, 1e-4f);
    // The middle of the last pixel of a row of five is 4/5 of the way from the middle to the end.
    EXPECT_NEAR(layer_pixel(frame, "depth", 4, 2).b, 10.0 * std::hypot(1.0, 0.8 * std::tan(0.3)), 1e-4);
}

TEST(Layers, IrradianceOfAWhiteEnvironmentIsPi)
{
    const environment::Environment white = testing::white_environment();
    Settings settings = testing::small_settings(3, 3, testing::front_camera(1.0f));
    settings.ambient_brightness = 2.0f; // is of the surface's light, not of what arrives
    for (const Model model : {Model::ggx, Model::phong}) {
        settings.model = model;
        const glm::vec3 irradiance = layer_pixel(draw_layers({}, settings, &white), "irradiance", 1, 1);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(irradiance[c], pi, 0.002 * pi);
    }
}

// A texel of a fifth at half the strength takes 2/5 of the ambient light, and of no other.
TEST(Layers, OcclusionDarkensAmbientLight)
{
    const environment::Environment white = testing::white_environment();
    scene::Light light;
    light.position = {0.0f, 0.0f, 2.0f};
    Settings settings = testing::small_settings(3, 3, testing::front_camera(1.0f));
    settings.lights = {light};
    for (const Model model : {Model::ggx, Model::phong}) {
        settings.model = model;
        scene::Material open;
        open.metallic = 0.0f;
        open.perceptual_roughness = 0.5f;
        open.base_color = {0.8f, 0.5f, 0.3f, 1.0f};
        scene::Material occluded = open;
        occluded.occlusion_texture.image = 0;
        occluded.occlusion_strength = 0.5f;
        const Frame bright = draw_layers(open, settings, &white),
                    dark = draw_layers(occluded, settings, &white);
        const auto ratio = [&](const char* name) {
            return layer_pixel(dark, name, 1, 1).g / layer_pixel(bright, name, 1, 1).g;
        };
        EXPECT_NEAR(ratio("light_ambient"), 0.6f, 1e-3f);
        EXPECT_EQ(ratio("light_direct"), 1.0f);
        EXPECT_EQ(ratio("light_specular"), 1.0f);
    }
}

} // namespace
} // namespace lambent::draw
