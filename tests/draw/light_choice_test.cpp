// Lights that are passed over must be those that would have added nothing.
#include "draw/cpu/cpu_renderer.h"
#include "draw/cpu/light_choice.h"
#include "scene/builtin/builtin.h"
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <limits>

namespace lambent::draw {
namespace {

LightSource lamp(const glm::vec3& position, float range)
{
    LightSource light;
    light.local = true;
    light.position = position;
    light.range = range;
    return light;
}

TEST(LightChoice, RangesThatEndBeforeTheBoxAreLeftOut)
{
    const scene::Bounds box = {{-1.0f, -1.0f, -1.0f}, {1.0f, 2.0f, 3.0f}};
    LightSource sun;
    const std::vector<LightSource> lights = {
        sun,                                                                 // shines everywhere
        lamp({0.0f, 0.0f, 0.0f}, 0.1f),                                      // inside
        lamp({3.0f, 0.0f, 0.0f}, 2.1f),                                      // reaches a face
        lamp({3.0f, 0.0f, 0.0f}, 1.9f),                                      // does not
        lamp({4.0f, 6.0f, 0.0f}, 5.1f),                                      // reaches an edge 3-4-5 away
        lamp({4.0f, 6.0f, 0.0f}, 4.9f),                                      // does not
        lamp({900.0f, 0.0f, 0.0f}, std::numeric_limits<float>::infinity())}; // unlimited
    std::vector<LightSource> chosen;
    choose_lights(lights, box, chosen);
    ASSERT_EQ(chosen.size(), 5u);
    EXPECT_FALSE(chosen[0].local);
    EXPECT_EQ(chosen[1].range, 0.1f);
    EXPECT_EQ(chosen[2].range, 2.1f);
    EXPECT_EQ(chosen[3].range, 5.1f);
    EXPECT_EQ(chosen[4].position.x, 900.0f);
}

// The light of each lamp alone, drawn by itself, adds up to that of all together.
TEST(LightChoice, ManyLampsAddUp)
{
    scene::Scene scene = scene::make_builtin("report");
    scene.lights.clear();
    const scene::Bounds box = scene::bounds(scene);
    Settings settings;
    settings.width = 64;
    settings.height = 48;
    settings.edge_samples = 1;
    settings.background.kind = Background::Kind::none;
    settings.camera = orbit_camera(box, {0.3f, 0.4f, 0.0f}, 0.7f, 4.0f / 3.0f);
    const std::unique_ptr<Renderer> renderer = make_cpu_renderer(scene);
    std::vector<scene::Light> lights;
    for (int i = 0; i < 24; ++i) {
        scene::Light light;
        const auto fraction = [&](int step) { return static_cast<float>(i * step % 24) / 23.0f; };
        light.position = box.low + glm::vec3(fraction(1), fraction(5), fraction(7)) * (box.high - box.low);
        light.range = 0.25f * glm::length(box.high - box.low);
        lights.push_back(light);
    }
    std::vector<float> sum(64 * 48 * 4, 0.0f);
    for (const scene::Light& light : lights) {
        settings.lights = {light};
        const Frame alone = renderer->draw(nullptr, settings);
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += alone.radiance.values[i];
    }
    settings.lights = lights;
    const Frame all = renderer->draw(nullptr, settings);
    double light = 0.0;
    for (std::size_t i = 0; i < sum.size(); ++i) {
        if (i % 4 == 3)
            continue; // coverage
        EXPECT_NEAR(all.radiance.values[i], sum[i], 1e-4f * sum[i] + 1e-6f) << i;
        light += static_cast<double>(sum[i]);
    }
    EXPECT_GT(light, 1.0);
}

} // namespace
} // namespace lambent::draw
