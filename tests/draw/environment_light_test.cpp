// The environment as background and in mirrors: where it is, which way it turns, how sharp it is.
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambent::draw {
namespace {

using testing::pixel;

// A lamp of a radius in degrees.
environment::Environment lamp(glm::dvec3 towards, double radius = 5.0, int width = 512)
{
    const glm::dvec3 axis = glm::normalize(towards);
    return testing::environment_of(width, [=](glm::dvec3 d) {
        return glm::dot(d, axis) > std::cos(radius * std::numbers::pi / 180.0) ? glm::vec3(1.0f)
                                                                               : glm::vec3(0.0f);
    });
}

// A camera at the origin, looking along -Z, 90 degrees high and wide.
Settings look_out(int size)
{
    Camera camera;
    camera.vertical_fov = 1.5707963f;
    Settings settings = testing::small_settings(size, size, camera);
    settings.background.kind = Background::Kind::environment;
    return settings;
}

TEST(EnvironmentLight, BackgroundIsWhereItsDirectionIs)
{
    scene::Scene nothing;
    nothing.materials.emplace_back();
    const environment::Environment ahead = lamp({0, 0, -1}), right = lamp({0.5, 0, -1}),
                                   above = lamp({0, 0.5, -1});
    EXPECT_NEAR(pixel(testing::draw(nothing, &ahead, look_out(101)), 50, 50).r, 1.0f, 1e-2f);
    EXPECT_NEAR(pixel(testing::draw(nothing, &right, look_out(101)), 75, 50).r, 1.0f, 1e-2f);
    EXPECT_NEAR(pixel(testing::draw(nothing, &above, look_out(101)), 50, 25).r, 1.0f, 1e-2f);
    EXPECT_EQ(pixel(testing::draw(nothing, &above, look_out(101)), 50, 75).r, 0.0f);
    EXPECT_EQ(pixel(testing::draw(nothing, &above, look_out(101)), 50, 25).a, 0.0f);
}

TEST(EnvironmentLight, RotationTurnsCounterClockwiseSeenFromAbove)
{
    scene::Scene nothing;
    nothing.materials.emplace_back();
    const environment::Environment at_x = lamp({1, 0, 0});
    Settings settings = look_out(101);
    settings.environment_rotation = 1.5707963f; // +X goes to -Z, as glTF's rotations about +Y do
    EXPECT_NEAR(pixel(testing::draw(nothing, &at_x, settings), 50, 50).r, 1.0f, 1e-2f);
}

// A mirror at 45 degrees shows what is straight up; a rough one shows it blurred.
TEST(EnvironmentLight, MirrorsShowTheMirroredDirection)
{
    scene::Scene scene;
    scene::Material mirror;
    mirror.metallic = 1.0f;
    mirror.perceptual_roughness = 0.0f;
    testing::add(scene, testing::facing_square(1.0f, 0.0f), mirror,
                 glm::rotate(glm::mat4(1.0f), -0.78539816f, glm::vec3(1, 0, 0)));
    const Settings settings = testing::small_settings(9, 9, testing::front_camera(0.5f));
    const environment::Environment above = lamp({0, 1, 0}), beside = lamp({1, 0, 0});
    // The lamp, whose middle is just there, is a lamp of the lobe's, too, to a little extent.
    EXPECT_NEAR(pixel(testing::draw(scene, &above, settings), 4, 4).r, 1.0f, 2e-2f);
    EXPECT_NEAR(pixel(testing::draw(scene, &beside, settings), 4, 4).r, 0.0f, 1e-2f);
    scene.materials[0].perceptual_roughness = 0.5f;
    const float blurred = pixel(testing::draw(scene, &above, settings), 4, 4).r;
    EXPECT_GT(blurred, 0.02f);
    EXPECT_LT(blurred, 0.6f);
}

// A mirroring sphere a few pixels wide shows the whole sphere of directions: its pixels must average, not pick. By either
// model; the report's mirrors send on a part of the light, which depends on the angle and hardly changes in a pixel.
TEST(EnvironmentLight, MirrorsAverageOverTheirPixels)
{
    const environment::Environment stripes = testing::environment_of(512, [](glm::dvec3 d) {
        return glm::vec3(std::sin(60.0 * std::atan2(d.z, d.x)) > 0.0 ? 2.0f : 0.0f);
    });
    for (const Model model : {Model::ggx, Model::phong}) {
        scene::Scene scene;
        scene::Material mirror;
        mirror.metallic = 1.0f;
        mirror.perceptual_roughness = 0.0f;
        if (model == Model::phong)
            mirror.phong = scene::PhongMaterial{glm::vec3(0.0f), glm::vec3(1.0f), 1e6f};
        testing::add(scene, scene::make_sphere(0.5f, 128, 64), mirror);
        Settings coarse = testing::small_settings(16, 16, testing::front_camera(1.0f));
        coarse.edge_samples = 1;
        coarse.model = model;
        Settings fine = testing::small_settings(16 * 16, 16 * 16, testing::front_camera(1.0f));
        fine.edge_samples = 1;
        fine.model = model;
        const Frame small = testing::draw(scene, &stripes, coarse),
                    large = testing::draw(scene, &stripes, fine);
        for (int y = 5; y < 11; ++y)
            for (int x = 5; x < 11; ++x) {
                float mean = 0.0f;
                for (int k = 0; k < 256; ++k)
                    mean += pixel(large, 16 * x + k % 16, 16 * y + k / 16).r / 256.0f;
                EXPECT_NEAR(pixel(small, x, y).r, mean, 0.15f) << x << ' ' << y;
            }
    }
}

// The light of the pixels of look_out(size), by solid angle, and its mean squared angle from the middle.
struct Spot {
    double light = 0.0, squared_angle = 0.0;
};

Spot spot_of(const Frame& frame, int size)
{
    Spot spot;
    const double pixel_area = std::pow(2.0 / size, 2);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double u = 2.0 * (x + 0.5) / size - 1.0, v = 2.0 * (y + 0.5) / size - 1.0;
            const double r2 = u * u + v * v,
                         light = pixel(frame, x, y).r * pixel_area * std::pow(1.0 + r2, -1.5);
            spot.light += light;
            spot.squared_angle += light * std::pow(std::atan(std::sqrt(r2)), 2);
        }
    spot.squared_angle /= spot.light;
    return spot;
}

// All of a lamp's light is still there, only wider: the mean squared angle is the lamp's own, radius^2 / 2, and twice
// the square of the Gaussian's deviation, roughness^2. Bilinear texels of the panorama and of the chain add a little.
TEST(EnvironmentLight, BlurredBackgroundIsSmootherAndKeepsItsLight)
{
    scene::Scene nothing;
    nothing.materials.emplace_back();
    const environment::Environment ahead = lamp({0, 0, -1}, 5.0, 2048);
    const double radius = 5.0 * std::numbers::pi / 180.0,
                 solid_angle = 2.0 * std::numbers::pi * (1.0 - std::cos(radius));
    Settings settings = look_out(128);
    EXPECT_NEAR(spot_of(testing::draw(nothing, &ahead, settings), 128).light / solid_angle, 1.0, 0.03);
    settings.background.kind = Background::Kind::blurred;
    for (const float roughness : {0.2f, 0.3f, 0.4f}) {
        settings.background.roughness = roughness;
        const Frame blurred = testing::draw(nothing, &ahead, settings);
        const Spot spot = spot_of(blurred, 128);
        const double expected = 0.5 * radius * radius + 2.0 * std::pow(static_cast<double>(roughness), 4);
        EXPECT_NEAR(spot.light / solid_angle, 1.0, 0.02) << roughness;
        EXPECT_NEAR(spot.squared_angle / expected, 1.0, 0.05) << roughness;
    }
    const Frame widest = testing::draw(nothing, &ahead, settings);
    EXPECT_LT(pixel(widest, 64, 64).r, 0.6f);
    EXPECT_GT(pixel(widest, 64, 64).r, pixel(widest, 80, 64).r);
    EXPECT_GT(pixel(widest, 80, 64).r, pixel(widest, 120, 64).r);
}

// The report's own level choice is 1/2 log2(4 pi) = 1.83 levels coarser: a narrow lobe is blurred further.
TEST(EnvironmentLight, TheReportsLevelsAreCoarser)
{
    scene::Scene scene;
    scene::Material glossy;
    glossy.phong = scene::PhongMaterial{glm::vec3(0.0f), glm::vec3(1.0f), 15625.0f};
    testing::add(scene, testing::facing_square(1.0f, 0.0f), glossy);
    Settings settings = testing::small_settings(9, 9, testing::front_camera(0.5f));
    settings.model = Model::phong;
    const environment::Environment behind_us = lamp({0, 0, 1}, 1.0);
    const float matched = pixel(testing::draw(scene, &behind_us, settings), 4, 4).r;
    settings.mip_level = MipLevel::report;
    const float report = pixel(testing::draw(scene, &behind_us, settings), 4, 4).r;
    EXPECT_GT(report, 0.0f);
    EXPECT_LT(report, 0.6f * matched);
}

// Levels of the report's mip chain, seen: four texels lit around the mirrored direction are (texel of the panorama) /
// (texel of the level) bright in every level, by solid angle. Four Hammersley points of a lobe narrower than a texel of
// the level; the first, far out, reads the coarsest level, where next to nothing is left of the light.
TEST(EnvironmentLight, TheReportsLevelIsThatOfItsFormula)
{
    constexpr int width = 512, height = 256;
    constexpr double exponent = 15625.0;
    const double texel = 2.0 * std::numbers::pi / width;
    const environment::Environment spot = testing::environment_of(width, [=](glm::dvec3 d) {
        return d.z > 0.0 && std::fabs(d.x) < texel && std::fabs(d.y) < texel ? glm::vec3(1.0f)
                                                                             : glm::vec3(0.0f);
    });
    scene::Scene scene;
    scene::Material glossy;
    glossy.phong = scene::PhongMaterial{glm::vec3(0.0f), glm::vec3(1.0f), static_cast<float>(exponent)};
    testing::add(scene, testing::facing_square(1.0f, 0.0f), glossy);
    Settings settings = testing::small_settings(3, 3, testing::front_camera(0.01f));
    settings.model = Model::phong;
    settings.mip_level = MipLevel::report;
    settings.samples = 4;
    const auto brightness = [=](double level) {
        return std::sin(std::numbers::pi / height) /
               (std::exp2(level) * std::sin(std::numbers::pi / height * std::exp2(level)));
    };
    double expected = 0.0;
    for (const double xi2 : {0.5, 0.25, 0.75}) {
        const double NH = std::cos(0.5 * std::acos(std::pow(xi2, 1.0 / (exponent + 1.0))));
        const double D = (exponent + 2.0) / (2.0 * std::numbers::pi) * std::pow(NH, exponent);
        const double level = 0.5 * std::log2(width * height / 4.0) - 0.5 * std::log2(D / 4.0);
        const double below = std::floor(level), part = level - below;
        expected += 0.25 * 0.25 * ((1.0 - part) * brightness(below) + part * brightness(below + 1.0));
    }
    EXPECT_NEAR(pixel(testing::draw(scene, &spot, settings), 1, 1).r / expected, 1.0, 0.02);
}

} // namespace
} // namespace lambent::draw
