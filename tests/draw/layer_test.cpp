// The layers of the G-buffer and of the light, each by its name.
#include "environment/chain/cube_chain.h"
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
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
    for (const char* name : {"base_color", "specular", "alpha", "roughness", "metalness", "normal", "depth",
                             "occlusion", "mip_level", "irradiance", "light_emitted", "light_direct",
                             "light_ambient", "light_specular", "light_background"})
        EXPECT_NO_THROW(testing::layer_named(frame, name)) << name;
    EXPECT_THROW(testing::layer_named(frame, "exponent"), std::runtime_error);
    Settings phong = settings;
    phong.model = Model::phong;
    EXPECT_NO_THROW(testing::layer_named(draw_layers({}, phong), "exponent"));
    EXPECT_NO_THROW(testing::layer_named(draw_layers({}, phong), "diffuse"));
    EXPECT_NO_THROW(testing::layer_named(draw_layers({}, phong), "mip_level"));
    EXPECT_THROW(testing::layer_named(draw_layers({}, phong), "roughness"), std::runtime_error);
}

TEST(Layers, RoughnessIsPerceptual)
{
    const Settings settings = testing::small_settings(3, 3, testing::front_camera(1.0f));
    scene::Material material;
    for (const float roughness : {0.02f, 0.3f, 1.0f}) {
        material.perceptual_roughness = roughness;
        const Frame frame = draw_layers(material, settings);
        EXPECT_NEAR(layer_pixel(frame, "roughness", 1, 1).g, roughness, 1e-6f);
        EXPECT_NEAR(layer_pixel(frame, "alpha", 1, 1).g, roughness * roughness, 1e-6f);
    }
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

// A sphere of radius 1 as a view along Z sees it, 0.01 to a pixel.
constexpr int sphere_size = 201;
constexpr double sphere_step = 0.01;

Frame draw_sphere(const scene::Material& material, const environment::Environment& light, Settings settings)
{
    scene::Scene scene;
    testing::add(scene, scene::make_sphere(1.0f, 512, 256), material);
    settings.width = settings.height = sphere_size;
    settings.camera = testing::front_camera(static_cast<float>(sphere_step * sphere_size));
    settings.layers = true;
    return testing::draw(scene, &light, settings);
}

// What the layer says at a place of the sphere from its middle to the right, as a level.
double level_at(const Frame& frame, double x, double highest)
{
    const int column = sphere_size / 2 + static_cast<int>(std::lround(x / sphere_step));
    return highest * static_cast<double>(layer_pixel(frame, "mip_level", column, sphere_size / 2).g);
}

// The variance that a level of the chain stands for: levels of v1 4^(l - 1), level 0 of v1 / 16, and blends of them.
double variance_of(double level, const environment::CubeChain& chain)
{
    const auto whole = [](double l) { return l < 1.0 ? 1.0 / 16.0 : std::pow(4.0, l - 1.0); };
    const double below = std::floor(level), part = level - below,
                 deviation = environment::level_one_deviation(chain);
    return deviation * deviation * ((1.0 - part) * whole(below) + part * whole(below + 1.0));
}

// How much of the sphere of directions a pixel mirrors, and how long its sides are there: R = (2 x n.z, 2 y n.z, 2 n.z^2 - 1).
struct Mirrored {
    double area, longest2;
};

Mirrored mirrored_in_pixel(double x)
{
    const double c = std::sqrt(1.0 - x * x);
    const double across = 2.0 * sphere_step / c,
                 along = 2.0 * sphere_step * c; // each side's length: |dR/dx|, |dR/dy|
    return {across * along, across * across + along * along};
}

// Blurs are as wide as one sample's share of lobe and pixel: 0.3 / (N density); pixels that are narrow beside the lobe add a
// twelfth of their area.
double blur_of_sample(double density, const Mirrored& pixel, double samples)
{
    const double lobe = 0.3 / (samples * density), widest = 0.3 * pixel.longest2 / samples,
                 moved = widest / (widest + lobe);
    return lobe + 0.3 * pixel.area / samples + (1.0 - moved * moved) * pixel.area / 12.0;
}

// The density of visible normals where the facet faces along N, without those that mirror to below the horizon, of the lobe
// that is drawn, up to 1.25 times as wide.
double wanted_variance(double alpha, double NV, const Mirrored& pixel, double samples)
{
    const double w = alpha * (1.25 - 0.25 * alpha), w2 = w * w, s = 1.0 + std::sqrt(1.0 - NV * NV);
    const double G1 = 2.0 * NV / (NV + std::sqrt(w2 + (1.0 - w2) * NV * NV));
    const double bound = (1.0 - w2) * s * s / (s * s + w2 * NV * NV);
    const double stretched_z = NV / std::sqrt(w2 * (1.0 - NV * NV) + NV * NV);
    const double kept = (1.0 + bound * stretched_z) / (1.0 + stretched_z); // [Eto and Tokuyoshi 2023]
    return blur_of_sample(G1 / (pi * w2 * 4.0 * NV * kept), pixel, samples);
}

TEST(Layers, MipLevelIsAsWideAsAShareOfTheLobe)
{
    const environment::Environment light = testing::white_environment();
    const double highest = light.chain.levels - 1;
    int between = 0;
    for (const float roughness : {0.2f, 0.5f, 0.8f, 1.0f})
        for (const int samples : {8, 40, 200}) {
            Settings settings;
            settings.samples = samples;
            scene::Material material;
            material.perceptual_roughness = roughness;
            const Frame frame = draw_sphere(material, light, settings);
            for (const double x : {0.0, 0.3, 0.6}) {
                const double level = level_at(frame, x, highest);
                const double wanted = wanted_variance(std::pow(static_cast<double>(roughness), 2.0),
                                                      std::sqrt(1.0 - x * x), mirrored_in_pixel(x), samples);
                const double least = variance_of(0.0, light.chain), most = variance_of(highest, light.chain);
                EXPECT_NEAR(variance_of(level, light.chain) / std::clamp(wanted, least, most), 1.0, 0.01)
                    << roughness << ' ' << samples << ' ' << x;
                between += level > 0.0 && level < highest;
            }
        }
    EXPECT_GT(between, 12);
}

// The lobe's density in its middle is (exponent + 1) / (2 pi); the report's level is 1/2 log2(W H / N) - 1/2 log2(D(N) / 4), whatever the
// angle.
TEST(Layers, MipLevelOfPhongIsMatchedOrTheReports)
{
    const environment::Environment light = testing::white_environment();
    const double highest = light.chain.levels - 1,
                 highest_mip = std::log2(static_cast<double>(light.panorama.height));
    Settings settings;
    settings.model = Model::phong;
    settings.samples = 16;
    for (const float exponent : {1.0f, 20.0f, 625.0f, 15625.0f}) {
        scene::Material material = testing::matte(glm::vec3(0.5f));
        material.phong.exponent = exponent;
        const double a = static_cast<double>(exponent);
        settings.mip_level = MipLevel::matched;
        const Frame matched = draw_sphere(material, light, settings);
        settings.mip_level = MipLevel::report;
        const Frame report = draw_sphere(material, light, settings);
        const double D = (a + 2.0) / (2.0 * pi);
        const double level = 0.5 * std::log2(64.0 * 32.0 / 16.0) - 0.5 * std::log2(D / 4.0);
        for (const double x : {0.0, 0.6}) {
            const double wanted =
                std::clamp(blur_of_sample((a + 1.0) / (2.0 * pi), mirrored_in_pixel(x), 16.0),
                           variance_of(0.0, light.chain), variance_of(highest, light.chain));
            EXPECT_NEAR(variance_of(level_at(matched, x, highest), light.chain) / wanted, 1.0, 1e-3) << a;
            EXPECT_NEAR(level_at(report, x, highest_mip), std::clamp(level, 0.0, highest_mip), 1e-4) << a;
        }
    }
}

TEST(Layers, MipLevelIsNothingWithoutLookups)
{
    const Settings settings = testing::small_settings(3, 3, testing::front_camera(1.0f));
    EXPECT_EQ(layer_pixel(draw_layers({}, settings), "mip_level", 1, 1), glm::vec3(0.0f));
    const environment::Environment light = testing::white_environment();
    scene::Material unlit;
    unlit.unlit = true;
    EXPECT_EQ(layer_pixel(draw_layers(unlit, settings, &light), "mip_level", 1, 1), glm::vec3(0.0f));
    EXPECT_GT(layer_pixel(draw_layers({}, settings, &light), "mip_level", 1, 1).g, 0.0f);
}

} // namespace
} // namespace lambent::draw
