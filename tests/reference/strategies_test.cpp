// The environment's light is found in two ways. Either alone, and both together, give the same picture.
#include "tests/reference/traced.h"

#include <glm/ext/matrix_transform.hpp>

namespace lambent::reference {
namespace {

using namespace testing;

scene::Scene still_life(const scene::Material& ball, const scene::Material& wall)
{
    scene::Scene scene = scene_of(facing_square(3.0f, -0.5f), wall);
    add(scene, scene::make_sphere(0.5f, 64, 32), ball);
    scene::Material veil = metallic(0.5f, 0.0f, 0.8f);
    veil.alpha_mode = scene::AlphaMode::blend;
    veil.base_color.a = 0.4f;
    veil.double_sided = true;
    add(scene, facing_square(0.4f, 0.0f), veil, glm::translate(glm::mat4(1.0f), {0.5f, 0.5f, 0.7f}));
    return scene;
}

// A dim sky with a patch 30 times as bright, 25 degrees across.
image::RadianceImage patch()
{
    const glm::dvec3 middle = glm::normalize(glm::dvec3(0.5, 0.4, 0.8));
    return panorama_of(128, [=](const glm::dvec3& d) {
        const double dim = 0.5 + 0.3 * d.y;
        return d.x * middle.x + d.y * middle.y + d.z * middle.z > std::cos(0.22)
                   ? glm::dvec3(15.0, 12.0, 9.0)
                   : glm::dvec3(dim, dim, 1.2 * dim);
    });
}

// Compares by blocks of 4 x 4 pixels, 64 of three channels: one of them is further off than 5.5 deviations in 130,000.
void expect_same(const Result& a, const Result& b)
{
    for (int y = 0; y < 32; y += 4)
        for (int x = 0; x < 32; x += 4)
            for (int c = 0; c < 3; ++c) {
                const Average one = average(a, {x, y, 4, 4}, c), other = average(b, {x, y, 4, 4}, c);
                const double deviation = std::hypot(one.deviation, other.deviation);
                ASSERT_GT(deviation, 0.0);
                EXPECT_LT(std::fabs(one.mean - other.mean) / deviation, 5.5)
                    << "at " << x << ' ' << y << " channel " << c << ": " << one.mean << ' ' << other.mean;
            }
    const Average one = average(a, whole(a), 1), other = average(b, whole(b), 1);
    EXPECT_NEAR(one.mean, other.mean, deviations * std::hypot(one.deviation, other.deviation));
}

void compare(const scene::Scene& scene, view::Model model, int bounces)
{
    const image::RadianceImage light = patch();
    Settings settings = small_settings(32, 2.0f, 128);
    settings.model = model;
    settings.bounces = bounces;
    const Result both = trace(scene, &light, settings);
    settings.seed = 1;
    settings.strategy = Strategy::lights_only;
    const Result lights = trace(scene, &light, settings);
    settings.seed = 2;
    settings.samples = 512;
    settings.strategy = Strategy::reflections_only;
    const Result reflections = trace(scene, &light, settings);
    expect_same(both, lights);
    expect_same(both, reflections);
    EXPECT_LT(both.noise.value().all, 0.05);
}

TEST(ReferenceStrategies, AgreeOnGgx)
{
    const scene::Scene scene = still_life(metallic(0.8f, 0.5f, 0.6f), metallic(0.6f, 0.0f, 0.9f));
    for (const int bounces : {0, 1, 4}) {
        SCOPED_TRACE(bounces);
        compare(scene, view::Model::ggx, bounces);
    }
}

TEST(ReferenceStrategies, AgreeOnPhong)
{
    const scene::Scene scene = still_life(phong({0.6f, 0.3f, 0.1f}, glm::vec3(0.2f), 12.0f),
                                          phong(glm::vec3(0.5f), glm::vec3(0.0f), 2.0f));
    for (const int bounces : {0, 1, 4}) {
        SCOPED_TRACE(bounces);
        compare(scene, view::Model::phong, bounces);
    }
}

// A roof and a lamp of which the wall sees the backs: what those keep off, and send on, is the same for both ways.
TEST(ReferenceStrategies, AgreeUnderTheBacksOfOneSidedSurfaces)
{
    scene::Scene scene = still_life(metallic(0.8f, 0.5f, 0.6f), metallic(0.6f, 0.0f, 0.9f));
    add(scene, facing_square(0.6f, 0.0f), metallic(0.9f, 0.0f, 0.7f),
        glm::translate(glm::mat4(1.0f), {-0.9f, 0.2f, 0.4f}));
    scene::Material lamp = metallic(0.4f, 0.0f, 0.8f);
    lamp.emissive = glm::vec3(3.0f);
    const glm::mat4 turned =
        glm::rotate(glm::translate(glm::mat4(1.0f), {0.9f, -0.3f, 0.2f}), 1.2f, {0, 1, 0});
    add(scene, facing_square(0.4f, 0.0f), lamp, turned);
    for (const int bounces : {1, 4}) {
        SCOPED_TRACE(bounces);
        compare(scene, view::Model::ggx, bounces);
    }
}

} // namespace
} // namespace lambent::reference
