// Lights without size, shadows, and what is in front of what.
#include "tests/reference/small_scenes.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

namespace lambent::reference {
namespace {

using namespace testing;

glm::vec4 middle(const Result& result)
{
    const float* p = result.radiance.pixel(result.radiance.width / 2, result.radiance.height / 2);
    return {p[0], p[1], p[2], p[3]};
}

// A matte square seen head on: Kd / pi, and no highlight where light and view are both along the normal, VH = 1.
scene::Scene matte_square()
{
    scene::Scene scene;
    scene::Material m;
    m.phong = {glm::vec3(0.5f), glm::vec3(0.0f), 1.0f};
    add(scene, facing_square(1.0f), m);
    return scene;
}

Settings head_on()
{
    Settings settings = front_view(3, 0.003f, 16);
    settings.model = view::Model::phong;
    return settings;
}

scene::Light point_light(glm::vec3 position)
{
    scene::Light light;
    light.position = position;
    light.intensity = glm::vec3(3.0f);
    return light;
}

TEST(Lamps, FallOffWithTheSquare)
{
    for (float distance : {0.5f, 1.0f, 4.0f}) {
        Settings settings = head_on();
        settings.lights = {point_light({0.0f, 0.0f, distance})};
        const float expected = 0.5f / 3.14159265f * 3.0f / (distance * distance);
        EXPECT_NEAR(middle(trace(matte_square(), nullptr, settings)).x, expected, 1e-4f * expected)
            << distance;
    }
}

TEST(Lamps, SpotsLightTheirConeOnly)
{
    Settings settings = head_on();
    scene::Light spot = point_light({0.0f, 0.0f, 2.0f});
    spot.kind = scene::LightKind::spot;
    spot.direction = {0.0f, 0.0f, -1.0f};
    spot.inner_cone = 0.1f;
    spot.outer_cone = 0.3f;
    settings.lights = {spot};
    EXPECT_NEAR(middle(trace(matte_square(), nullptr, settings)).x, 0.5f / 3.14159265f * 0.75f, 1e-4f);
    settings.lights[0].direction = {std::sin(0.35f), 0.0f, -std::cos(0.35f)};
    EXPECT_EQ(middle(trace(matte_square(), nullptr, settings)).x, 0.0f);
}

// A square half way to the light blocks it, lets half of it through, or is not asked (no bounces: no shadows).
TEST(Lamps, ThrowShadows)
{
    const float open = 0.5f / 3.14159265f * 3.0f / 4.0f;
    for (float opacity : {1.0f, 0.5f, 0.0f})
        for (int bounces : {0, 1}) {
            scene::Scene scene = matte_square();
            scene::Material screen = lamp(glm::vec3(0.0f));
            screen.base_color.a = opacity;
            screen.alpha_mode = scene::AlphaMode::blend;
            screen.double_sided = true;
            // Off the line of sight, on the way of the light.
            add(scene, facing_square(0.2f), screen,
                glm::translate(glm::mat4(1.0f), glm::vec3(0.5f, 0.0f, 0.8660254f)));
            Settings settings = head_on();
            settings.samples = 64;
            settings.bounces = bounces;
            settings.lights = {point_light({1.0f, 0.0f, 1.7320508f})}; // 30 degrees off the normal, 2 m away
            const float lit = middle(trace(scene, nullptr, settings)).x;
            settings.lights[0].position.x = -1.0f; // the other side is open
            const float free = middle(trace(scene, nullptr, settings)).x;
            EXPECT_NEAR(free, open * 0.8660254f, 0.02f * open);
            EXPECT_NEAR(lit, bounces == 0 ? free : free * (1.0f - opacity), 1e-4f)
                << opacity << " " << bounces;
        }
}

TEST(Layers, BlendAndMaskShowWhatIsBehind)
{
    scene::Scene scene;
    scene::Material back = lamp({0.0f, 1.0f, 0.0f}), front = lamp({1.0f, 0.0f, 0.0f});
    front.base_color.a = 0.25f;
    front.alpha_mode = scene::AlphaMode::blend;
    add(scene, facing_square(1.0f, 0.5f), front);
    Settings settings = front_view(3, 0.1f, 4096);
    Result result = trace(scene, nullptr, settings);
    EXPECT_NEAR(middle(result).x, 0.25f, 0.02f);
    EXPECT_NEAR(middle(result).w, 0.25f, 0.02f); // coverage
    add(scene, facing_square(1.0f), back);
    result = trace(scene, nullptr, settings);
    EXPECT_NEAR(middle(result).x, 0.25f, 0.02f);
    EXPECT_NEAR(middle(result).y, 0.75f, 0.02f);
    EXPECT_EQ(middle(result).w, 1.0f);
    scene.materials[0].alpha_mode = scene::AlphaMode::mask; // 0.25 is below the cutoff of 0.5
    EXPECT_EQ(middle(trace(scene, nullptr, settings)).y, 1.0f);
    scene.materials[0].alpha_cutoff = 0.2f;
    EXPECT_EQ(middle(trace(scene, nullptr, settings)).x, 1.0f);
}

TEST(Layers, BacksOfOneSidedSurfacesAreNotThere)
{
    scene::Scene scene;
    add(scene, facing_square(1.0f), lamp(glm::vec3(1.0f)),
        glm::rotate(glm::mat4(1.0f), 3.14159265f, glm::vec3(0, 1, 0)));
    const Settings settings = front_view(3, 0.1f, 4);
    EXPECT_EQ(middle(trace(scene, nullptr, settings)).w, 0.0f);
    scene.materials[0].double_sided = true;
    EXPECT_EQ(middle(trace(scene, nullptr, settings)).w, 1.0f);
}

TEST(Pictures, PanoramasShowEachDirection)
{
    // A lamp on the +Z side: a quarter to the right of the middle.
    scene::Scene scene;
    scene::Material light = lamp(glm::vec3(1.0f));
    light.double_sided = true;
    add(scene, facing_square(0.3f, 1.0f), light);
    Settings settings;
    settings.panorama_from = glm::vec3(0.0f);
    settings.width = 32, settings.height = 16, settings.samples = 16;
    const Result result = trace(scene, nullptr, settings);
    EXPECT_EQ(result.radiance.pixel(24, 8)[0], 1.0f);
    EXPECT_EQ(result.radiance.pixel(23, 7)[0], 1.0f);
    EXPECT_EQ(result.radiance.pixel(16, 8)[0], 0.0f);
    EXPECT_EQ(result.radiance.pixel(8, 8)[0], 0.0f);
}

TEST(Pictures, BackgroundsAndRotation)
{
    // Radiance 2 around +X, and the camera looks along -Z: a quarter turn brings it there.
    const image::RadianceImage light =
        panorama(64, [](glm::dvec3 d) { return glm::dvec3(d.x > 0.8 ? 2.0 : 0.5); });
    Settings settings = front_view(3, 0.1f, 64);
    EXPECT_EQ(middle(trace({}, &light, settings)).x, 0.0f);
    settings.background.kind = view::Background::Kind::environment;
    EXPECT_EQ(middle(trace({}, &light, settings)).x, 0.5f);
    settings.environment_rotation = 1.5707963f; // counter-clockwise seen from above: +X goes to -Z
    EXPECT_EQ(middle(trace({}, &light, settings)).x, 2.0f);
    settings.background = {view::Background::Kind::blurred, {}, 1.0f};
    EXPECT_GT(middle(trace({}, &light, settings)).x, 0.5f);
    EXPECT_LT(middle(trace({}, &light, settings)).x, 2.0f);
    settings.background = {view::Background::Kind::color, {1.0f, 2.0f, 3.0f}, 0.0f};
    EXPECT_EQ(middle(trace({}, &light, settings)), glm::vec4(1.0f, 2.0f, 3.0f, 0.0f));
}

TEST(Pictures, DoNotDependOnTheNumberOfThreads)
{
    const image::RadianceImage light = panorama(32, [](glm::dvec3 d) { return glm::dvec3(1.0 + d.y); });
    scene::Scene scene;
    add(scene, scene::make_sphere(0.5f, 32, 16), metallic(glm::vec3(0.7f), 0.5f, 0.5f));
    Settings settings = front_view(40, 1.2f, 24);
    const Result many = trace(scene, &light, settings);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(trace(scene, &light, settings).radiance.values, many.radiance.values);
    EXPECT_EQ(many.samples, 24.0);
}

TEST(Pictures, StoppedEarlyTheyAreWhole)
{
    const image::RadianceImage light = white_panorama();
    scene::Scene scene;
    add(scene, scene::make_sphere(0.5f, 32, 16), metallic(glm::vec3(1.0f), 1.0f, 0.5f));
    Settings settings = front_view(64, 1.2f, 1 << 20);
    settings.background.kind = view::Background::Kind::environment;
    const Result result = trace(scene, &light, settings, [](const Progress&) { return false; });
    EXPECT_TRUE(result.stopped);
    EXPECT_GE(result.samples, 1.0);
    EXPECT_LT(result.samples, 32.0);
    EXPECT_EQ(result.radiance.pixel(0, 0)[0], 1.0f);
    EXPECT_EQ(result.radiance.pixel(63, 63)[0], 1.0f);
    settings.seconds = 0.05;
    EXPECT_LT(trace(scene, &light, settings).samples, 1e5);
}

} // namespace
} // namespace lambent::reference
