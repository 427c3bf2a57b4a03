// Pictures with bounces where the light is known in closed form.
#include "tests/draw/pose_scenes.h"
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lambent::draw::testing {
namespace {

scene::Material chalk(float reflectance)
{
    scene::Material material;
    material.base_color = {reflectance, reflectance, reflectance, 1.0f};
    material.metallic = 0.0f;
    material.perceptual_roughness = 1.0f;
    return material;
}

// What absorbs all light.
scene::Material soot()
{
    scene::Material material;
    material.base_color = {0.0f, 0.0f, 0.0f, 1.0f};
    material.unlit = true;
    return material;
}

scene::Light light_along(glm::vec3 direction)
{
    scene::Light light;
    light.kind = scene::LightKind::directional;
    light.direction = glm::normalize(direction);
    light.intensity = glm::vec3(3.0f);
    return light;
}

Settings shadowed(int width, int height, float extent, int bounces)
{
    Settings settings = small_settings(width, height, front_camera(extent));
    settings.bounces = bounces;
    return settings;
}

// Position on the plane z = 0 of a pixel's centre.
glm::vec2 place_of(const Settings& settings, int x, int y)
{
    const float size = settings.camera.vertical_size / static_cast<float>(settings.height);
    return {(static_cast<float>(x) + 0.5f - 0.5f * static_cast<float>(settings.width)) * size,
            (0.5f * static_cast<float>(settings.height) - static_cast<float>(y) - 0.5f) * size};
}

// A small square between the light and a wall: its shadow is its projection along the light, and nothing else changes.
TEST(Shadows, OfASquareUnderASunAreItsProjection)
{
    scene::Scene scene;
    add(scene, facing_square(2.0f, 0.0f), chalk(0.5f));
    add(scene, facing_square(0.3f, 0.5f), soot());
    scene.lights = {light_along({0.4f, 0.2f, -1.0f})};
    Settings settings = shadowed(80, 80, 2.4f, 1);
    const Frame with = draw(scene, nullptr, settings);
    settings.bounces = 0;
    const Frame without = draw(scene, nullptr, settings);
    int dark = 0, lit = 0;
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 80; ++x) {
            const glm::vec2 place = place_of(settings, x, y);
            const glm::vec2 in_square = glm::abs(place), in_shadow = glm::abs(place - glm::vec2(0.2f, 0.1f));
            const float square = std::max(in_square.x, in_square.y),
                        shadow = std::max(in_shadow.x, in_shadow.y);
            if (square < 0.33f || std::fabs(shadow - 0.3f) < 0.06f)
                continue; // the square itself, and pixels at the shadow's edge
            const float wanted = shadow < 0.3f ? 0.0f : pixel(without, x, y).g;
            EXPECT_NEAR(pixel(with, x, y).g, wanted, 1e-5f) << x << ' ' << y;
            ++(shadow < 0.3f ? dark : lit);
        }
    EXPECT_GT(dark, 50);
    EXPECT_GT(lit, 3000);
}

// A pane of opacity 0.3 lets 0.7 of a sun's light through.
TEST(Shadows, OfAPaneAreAsDarkAsItIsOpaque)
{
    scene::Scene scene;
    add(scene, facing_square(2.0f, 0.0f), chalk(0.5f));
    scene::Material pane = soot();
    pane.alpha_mode = scene::AlphaMode::blend;
    pane.base_color.a = 0.3f;
    // Beside the camera's view, so that only its shadow is seen.
    scene::Mesh square = facing_square(0.5f, 1.0f);
    for (glm::vec3& position : square.positions)
        position.x += 2.0f;
    add(scene, square, pane);
    scene.lights = {light_along({-2.0f, 0.0f, -1.0f})};
    Settings settings = shadowed(48, 48, 0.9f, 1);
    settings.passes = 32;
    const Frame with = draw(scene, nullptr, settings);
    settings.bounces = 0;
    const Frame without = draw(scene, nullptr, settings);
    double sum = 0.0, whole = 0.0;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x)
            sum += pixel(with, x, y).g, whole += pixel(without, x, y).g;
    // 48 x 48 pixels of 64 samples each: a standard deviation of 0.0012.
    EXPECT_NEAR(sum / whole, 0.7, 0.006);
}

// A wall of soot on a white floor, so tall and wide that from the camera's part of the floor it hides all directions
// with x > 0.
scene::Scene beside_a_wall()
{
    scene::Scene scene;
    add(scene, facing_square(100.0f, 0.0f), chalk(1.0f));
    scene::Mesh wall;
    wall.positions = {
        {1.0f, -1000.0f, 0.0f}, {1.0f, 1000.0f, 0.0f}, {1.0f, 1000.0f, 1000.0f}, {1.0f, -1000.0f, 1000.0f}};
    wall.normals.assign(4, {-1.0f, 0.0f, 0.0f});
    wall.triangles = {{0, 1, 2}, {0, 2, 3}};
    add(scene, wall, soot());
    return scene;
}

double mean_green(const Frame& frame)
{
    double sum = 0.0;
    for (std::size_t i = 1; i < frame.radiance.values.size(); i += 4)
        sum += static_cast<double>(frame.radiance.values[i]);
    return 4.0 * sum / static_cast<double>(frame.radiance.values.size());
}

// In a white environment a wall of soot that stands on the floor takes half the light of the floor at its foot: half of
// the cosine-weighted hemisphere, wherever the wall is tall and wide enough. [form factor of perpendicular half-planes]
TEST(Shadows, OfAWallTakeHalfTheSkyAtItsFoot)
{
    const scene::Scene scene = beside_a_wall();
    const environment::Environment white = white_environment();
    Settings settings = shadowed(48, 48, 1.5f, 8);
    settings.passes = 16;
    const Frame frame = draw(scene, &white, settings);
    EXPECT_NEAR(mean_green(frame), 0.5, 0.01); // white chalk in a white furnace sends all of what arrives
}

// Most of the light is behind the wall, and rays read the environment through blurs that reach around it: the more rays,
// the less. Expected is the integral over the other half of the sky, by quadrature.
TEST(Shadows, OfAWallBeforeTheLightAreRightInTheEnd)
{
    const auto radiance = [](const glm::dvec3& d) { return std::pow(0.5 * (1.0 + d.x), 4.0); };
    constexpr int steps = 400;
    constexpr double pi = 3.141592653589793;
    double expected = 0.0;
    for (int i = 0; i < steps; ++i)
        for (int k = 0; k < steps; ++k) {
            const double z = std::sqrt((i + 0.5) / steps), ring = std::sqrt(1.0 - z * z),
                         turn = pi * (0.5 + (k + 0.5) / steps);
            expected += radiance({ring * std::cos(turn), ring * std::sin(turn), z}) / (2.0 * steps * steps);
        }
    const environment::Environment behind =
        environment_of(128, [&](glm::dvec3 d) { return glm::vec3(static_cast<float>(radiance(d))); });
    Settings settings = shadowed(16, 16, 1.5f, 1);
    settings.passes = 512;
    const double found = mean_green(draw(beside_a_wall(), &behind, settings));
    EXPECT_NEAR(found / expected, 1.0, 0.1); // 2 passes: twice as bright
}

// No light finds its way into a closed sphere.
TEST(Shadows, AClosedRoomIsDark)
{
    scene::Scene scene;
    scene::Material material = chalk(0.8f);
    material.double_sided = true;
    add(scene, scene::make_sphere(1.0f, 32, 16), material);
    const environment::Environment white = white_environment();
    Settings settings = small_settings(48, 32, Camera());
    settings.camera.position = {0.1f, 0.2f, 0.3f};
    settings.bounces = 8;
    const Frame frame = draw(scene, &white, settings);
    EXPECT_FLOAT_EQ(pixel(frame, 24, 16).a, 1.0f);
    double sum = 0.0;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 48; ++x)
            sum += static_cast<double>(pixel(frame, x, y).g) / (48.0 * 32.0);
    EXPECT_LT(sum, 0.01);
}

// What nothing shadows is drawn as without bounces: a convex body in any environment, but for what its triangles, which are
// flat, hide at its rim.
TEST(Shadows, AConvexBodyHasNone)
{
    scene::Scene scene;
    scene::Material material = chalk(0.5f);
    material.perceptual_roughness = 0.3f;
    add(scene, scene::make_sphere(0.5f, 64, 32), material);
    const environment::Environment coloured =
        environment_of(64, [](glm::dvec3 d) { return glm::vec3(1.0f + 0.9f * glm::vec3(d)); });
    Settings settings = shadowed(64, 64, 1.2f, 8);
    const Frame with = draw(scene, &coloured, settings);
    settings.bounces = 0;
    const Frame without = draw(scene, &coloured, settings);
    for (std::size_t i = 0; i < with.radiance.values.size(); ++i)
        EXPECT_NEAR(with.radiance.values[i], without.radiance.values[i], 0.01f);
}

TEST(Shadows, AreTheSameInPiecesAndOnAnyNumberOfThreads)
{
    const environment::Environment white = white_environment();
    const scene::Scene scene = pose_scene(0.0f);
    Settings settings = pose_settings();
    settings.width = 150, settings.height = 100;
    settings.bounces = 3;
    const Frame wanted = draw(scene, &white, settings);
    {
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        EXPECT_EQ(draw(scene, &white, settings).radiance.values, wanted.radiance.values);
    }
    const std::unique_ptr<Renderer> renderer = make_cpu_renderer(scene);
    const std::unique_ptr<Drawing> drawing = renderer->start(&white, settings);
    float last = 0.0f;
    int pieces = 1;
    const auto stop = [&](float done) {
        EXPECT_GE(done, last);
        last = done;
        return false;
    };
    for (; !drawing->advance(stop); ++pieces)
        ;
    EXPECT_GT(pieces, 20);
    EXPECT_FLOAT_EQ(last, 1.0f);
    EXPECT_EQ(drawing->take().radiance.values, wanted.radiance.values);
}

// Each picture on the way is that of as many passes at once, and the last as well.
TEST(Shadows, ARefinedPictureIsThatOfAllItsPasses)
{
    const scene::Scene scene = pose_scene(0.0f);
    const environment::Environment white = white_environment();
    Settings settings = pose_settings();
    settings.bounces = 2;
    const auto at_once = [&](int passes) {
        Settings all = settings;
        all.passes = passes;
        return draw(scene, &white, all).radiance.values;
    };
    const std::unique_ptr<Renderer> renderer = make_cpu_renderer(scene);
    settings.passes = 1;
    const std::unique_ptr<Drawing> drawing = renderer->start(&white, settings);
    ASSERT_TRUE(drawing->advance({}));
    EXPECT_EQ(drawing->picture({}).radiance.values, at_once(1));
    drawing->refine(2);
    while (!drawing->advance([](float) { return false; }))
        ;
    EXPECT_EQ(drawing->picture({}).radiance.values, at_once(3));
    EXPECT_NE(drawing->picture({}).radiance.values, at_once(1));
    drawing->refine(1);
    ASSERT_TRUE(drawing->advance({}));
    EXPECT_EQ(drawing->take().radiance.values, at_once(4));
}

TEST(Shadows, APictureWithoutBouncesIsNotRefined)
{
    const scene::Scene scene = pose_scene(0.0f);
    const std::unique_ptr<Renderer> renderer = make_cpu_renderer(scene);
    const std::unique_ptr<Drawing> drawing = renderer->start(nullptr, pose_settings());
    ASSERT_TRUE(drawing->advance({}));
    EXPECT_THROW(drawing->refine(1), Error);
    EXPECT_THROW(drawing->picture({}), Error);
}

TEST(Shadows, LayersOfLightAddUpToThePicture)
{
    const environment::Environment white = white_environment();
    Settings settings = pose_settings();
    settings.bounces = 2;
    settings.layers = true;
    const Frame frame = draw(pose_scene(0.0f), &white, settings);
    for (int y = 0; y < settings.height; ++y)
        for (int x = 0; x < settings.width; ++x) {
            glm::vec3 sum(0.0f);
            for (const Layer& layer : frame.layers)
                if (layer.name.starts_with("light_"))
                    sum += layer_pixel(frame, layer.name, x, y);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(sum[c], pixel(frame, x, y)[c], 2e-5f) << x << ' ' << y;
        }
}

} // namespace
} // namespace lambent::draw::testing
