// Lights without size, and the sun as a few texels of the sky: closed forms.
#include "tests/reference/closed_phong.h"
#include "tests/reference/traced.h"

#include <glm/ext/matrix_transform.hpp>

namespace lambent::reference {
namespace {

using namespace testing;

const glm::dvec3 up(0.0, 0.0, 1.0); // of the plane that is lit, towards the camera

// A spot of a plane so small that all of it sees the lamp alike.
double lit(const scene::Scene& scene, const scene::Light& lamp, int bounces)
{
    Settings settings = small_settings(2, 1e-3f, 8);
    settings.model = view::Model::phong;
    settings.bounces = bounces;
    settings.lights = {lamp};
    const Result result = trace(scene, nullptr, settings);
    return average(result, whole(result), 0).mean;
}

scene::Scene plane(const scene::Material& material)
{
    return scene_of(facing_square(5.0f, 0.0f), material);
}

const scene::Material glossy = phong(glm::vec3(0.5f), glm::vec3(0.25f), 8.0f);
const ClosedPhong closed{0.5, 0.25, 8.0};

// What the plane at the origin shows of `lux` from `place`.
double shown(const glm::dvec3& place, double lux)
{
    const glm::dvec3 light = glm::normalize(place);
    return closed.brdf(up, up, light) * light.z * lux;
}

scene::Light point_at(const glm::vec3& place, float candela)
{
    scene::Light lamp;
    lamp.position = place;
    lamp.intensity = glm::vec3(candela);
    return lamp;
}

TEST(ReferenceLamps, PointLightsFallOffWithTheSquare)
{
    for (const glm::vec3 place :
         {glm::vec3(0, 0, 1), glm::vec3(0, 0, 4), glm::vec3(1, -2, 2), glm::vec3(3, 0, 0.5)})
        for (const int bounces : {0, 1, 8}) {
            const glm::dvec3 p(place);
            const double expected = shown(p, 10.0 / glm::dot(p, p));
            EXPECT_NEAR(lit(plane(glossy), point_at(place, 10.0f), bounces), expected, 1e-3 * expected);
        }
    EXPECT_EQ(lit(plane(glossy), point_at({1, 0, -2}, 10.0f), 1), 0.0) << "from behind";
}

TEST(ReferenceLamps, NothingIsLitBeyondTheirRange)
{
    scene::Light lamp = point_at({0, 0, 2}, 10.0f);
    lamp.range = 4.0f;
    // [KHR_lights_punctual] (1 - (d / range)^4) / d^2
    const double expected = shown({0, 0, 2}, 10.0 * (1.0 - 1.0 / 16.0) / 4.0);
    EXPECT_NEAR(lit(plane(glossy), lamp, 1), expected, 1e-3 * expected);
    lamp.range = 1.9f;
    EXPECT_EQ(lit(plane(glossy), lamp, 1), 0.0);
}

TEST(ReferenceLamps, SpotsAreConesWithSoftRims)
{
    scene::Light lamp = point_at({0, 0, 2}, 10.0f);
    lamp.kind = scene::LightKind::spot;
    lamp.inner_cone = 0.3f;
    lamp.outer_cone = 0.6f;
    for (const double angle : {0.0, 0.2, 0.35, 0.45, 0.55, 0.7}) {
        lamp.direction = {static_cast<float>(std::sin(angle)), 0.0f, static_cast<float>(-std::cos(angle))};
        const double between = (std::cos(angle) - std::cos(0.6)) / (std::cos(0.3) - std::cos(0.6));
        const double share = std::pow(std::clamp(between, 0.0, 1.0), 2.0);
        const double expected = shown({0, 0, 2}, share * 10.0 / 4.0);
        EXPECT_NEAR(lit(plane(glossy), lamp, 1), expected, 2e-3 * expected) << angle;
    }
}

TEST(ReferenceLamps, DirectionalLightsAreTheSameEverywhere)
{
    scene::Light lamp;
    lamp.kind = scene::LightKind::directional;
    lamp.intensity = glm::vec3(3.0f);
    lamp.direction = glm::normalize(glm::vec3(-1.0f, 0.5f, -1.0f));
    const double expected = shown(-glm::dvec3(lamp.direction), 3.0);
    EXPECT_NEAR(lit(plane(glossy), lamp, 1), expected, 1e-4 * expected);
}

// Twelve lamps are not all asked at every point: one is, for all of them.
TEST(ReferenceLamps, ManyLampsAddUp)
{
    Settings settings = small_settings(16, 1e-3f, 512);
    settings.model = view::Model::phong;
    double expected = 0.0;
    for (int i = 0; i < 12; ++i) {
        const glm::vec3 place(0.3f * static_cast<float>(i), 1.0f, 1.0f + 0.2f * static_cast<float>(i));
        settings.lights.push_back(point_at(place, 5.0f));
        expected += shown(glm::dvec3(place), 5.0 / glm::dot(glm::dvec3(place), glm::dvec3(place)));
    }
    const Result result = trace(plane(glossy), nullptr, settings);
    EXPECT_GT(average(result, whole(result), 0).deviation, 0.0);
    expect_light(result, glm::dvec3(expected), 1e-3);
}

// A square half way to the lamp at (2, 0, 2), which the camera does not see.
scene::Scene blocked(scene::Material blocker, float at = 1.0f, float turn = 0.0f)
{
    scene::Scene scene = plane(glossy);
    const glm::mat4 placed = glm::rotate(glm::translate(glm::mat4(1.0f), {at, 0.0f, 0.0f}), turn, {1, 0, 0});
    add(scene, facing_square(0.3f, turn != 0.0f ? -at : at), std::move(blocker), placed);
    return scene;
}

TEST(ReferenceLamps, WhatIsInTheWayThrowsAShadow)
{
    const scene::Light lamp = point_at({2, 0, 2}, 10.0f);
    const double open = lit(plane(glossy), lamp, 1);
    scene::Material wall = phong(glm::vec3(0.0f), glm::vec3(0.0f), 1.0f);
    wall.double_sided = true;
    ASSERT_GT(open, 0.0);
    EXPECT_EQ(lit(blocked(wall), lamp, 1), 0.0);
    EXPECT_EQ(lit(blocked(wall), lamp, 0), open) << "without bounces nothing has a shadow";
    EXPECT_EQ(lit(blocked(wall, 3.0f), lamp, 1), open) << "what is beyond the lamp has none either";
    wall.double_sided = false;
    EXPECT_EQ(lit(blocked(wall), lamp, 1), 0.0) << "backs that are not drawn have one";
    EXPECT_EQ(lit(blocked(wall), lamp, 0), open);
    EXPECT_EQ(lit(blocked(wall, 1.0f, static_cast<float>(pi)), lamp, 1), 0.0) << "as their fronts have";
}

TEST(ReferenceLamps, HalfOpacityIsHalfAShadow)
{
    const scene::Light lamp = point_at({2, 0, 2}, 10.0f);
    scene::Material veil = phong(glm::vec3(0.0f), glm::vec3(0.0f), 1.0f);
    veil.base_color.a = 0.5f;
    const double open = lit(plane(glossy), lamp, 1);
    for (const bool double_sided : {true, false}) {
        veil.double_sided = double_sided;
        veil.alpha_mode = scene::AlphaMode::blend;
        EXPECT_NEAR(lit(blocked(veil), lamp, 1), 0.5 * open, 1e-5 * open);
        veil.alpha_mode = scene::AlphaMode::mask;
        veil.alpha_cutoff = 0.6f;
        EXPECT_EQ(lit(blocked(veil), lamp, 1), open);
        veil.alpha_cutoff = 0.4f;
        EXPECT_EQ(lit(blocked(veil), lamp, 1), 0.0);
    }
}

// One bright texel of 256 x 128, read bilinearly, is a tent: its light is radiance * step * sin(theta) *
// 2 (1 - cos step) / step, from all but one direction.
TEST(ReferenceLamps, ASunOfOneTexelIsADirectionalLight)
{
    const int column = 200, row = 50;
    image::RadianceImage sky = panorama_of(256, [](const glm::dvec3&) { return glm::dvec3(0.0); });
    for (int c = 0; c < 3; ++c)
        sky.pixel(column, row)[c] = 1e4f;
    const double step = pi / 128.0, theta = (row + 0.5) * step,
                 phi = ((column + 0.5) / 256.0 - 0.5) * 2.0 * pi;
    const glm::dvec3 sun(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
    const double lux = 1e4 * std::sin(theta) * 2.0 * (1.0 - std::cos(step));
    ASSERT_GT(sun.z, 0.5);
    for (const int bounces : {0, 1}) {
        Settings settings = small_settings(16, 1.0f, 128);
        settings.model = view::Model::phong;
        settings.bounces = bounces;
        expect_light(trace(plane(glossy), &sky, settings), glm::dvec3(shown(sun, lux)), 1e-3);
    }
    // The other model, by the tracer's own lamps.
    const scene::Scene rough = plane(metallic(0.6f, 0.5f, 0.7f));
    Settings settings = small_settings(16, 1.0f, 128);
    const Result by_sky = trace(rough, &sky, settings);
    scene::Light lamp;
    lamp.kind = scene::LightKind::directional;
    lamp.intensity = glm::vec3(static_cast<float>(lux));
    lamp.direction = -glm::vec3(sun);
    settings.lights = {lamp};
    const Result by_lamp = trace(rough, nullptr, settings);
    EXPECT_NEAR(average(by_lamp, whole(by_lamp), 0).deviation, 0.0, 1e-6);
    expect_light(by_sky, glm::dvec3(average(by_lamp, whole(by_lamp), 0).mean), 1e-3);
}

} // namespace
} // namespace lambent::reference
