// Surfaces with a front only: cameras look through their backs, light does not.
#include "tests/reference/closed_phong.h"
#include "tests/reference/traced.h"

#include <glm/ext/matrix_transform.hpp>

namespace lambent::reference {
namespace {

using namespace testing;

constexpr Strategy all_strategies[] = {Strategy::both, Strategy::lights_only, Strategy::reflections_only};
constexpr double half = 0.7, height = 0.5;

// A floor and, above it, a square roof that faces away from it: the camera is between them.
scene::Scene below(const scene::Material& floor, const scene::Material& roof)
{
    scene::Scene scene = scene_of(facing_square(20.0f, 0.0f), floor);
    add(scene, facing_square(static_cast<float>(half), static_cast<float>(height)), roof);
    return scene;
}

Result floor_under(const scene::Scene& scene, const image::RadianceImage* light, Settings settings)
{
    settings.camera.position.z = 0.5f * static_cast<float>(height);
    return trace(scene, light, settings);
}

// The part of the sky's light that the roof keeps off the point under its middle, by the cosine: that of four
// right-angled quarters. [Howell 2010, configuration factor B-4]
double form_factor()
{
    const double ratio = half / height, root = std::sqrt(1.0 + ratio * ratio);
    return 4.0 / (2.0 * pi) * 2.0 * ratio / root * std::atan(ratio / root);
}

// Under a white sky.
TEST(OneSided, ABlackRoofKeepsItsFormFactorOff)
{
    const image::RadianceImage white = white_panorama();
    const scene::Scene scene =
        below(phong(glm::vec3(0.5f), glm::vec3(0.0f), 50.0f), phong(glm::vec3(0.0f), glm::vec3(0.0f), 50.0f));
    const double highlight = ClosedPhong{0.0, 0.0, 50.0}.head_on([](double) { return 1.0; });
    Settings settings = small_settings(4, 0.002f, 4096);
    settings.model = view::Model::phong;
    for (const int bounces : {1, 2})
        for (const Strategy strategy : all_strategies) {
            settings.bounces = bounces;
            settings.strategy = strategy;
            const Result result = floor_under(scene, &white, settings);
            const Average m = average(result, whole(result), 0);
            EXPECT_NEAR(m.mean, 0.5 * (1.0 - form_factor()), 2.0 * highlight + deviations * m.deviation)
                << bounces << ' ' << static_cast<int>(strategy);
            EXPECT_LT(m.deviation, 0.005);
        }
    EXPECT_LT(highlight, 0.002);
    settings.bounces = 0;
    const Result open = floor_under(scene, &white, settings);
    const Average m = average(open, whole(open), 0);
    EXPECT_NEAR(m.mean, 0.5, highlight + deviations * m.deviation) << "without shadows";
}

// Backs reflect what fronts do: where nothing absorbs, all is as bright as the sky.
TEST(OneSided, NothingIsLostUnderAWhiteRoof)
{
    const image::RadianceImage white = white_panorama();
    const scene::Scene scene = below(metallic(1.0f, 1.0f, 1.0f), metallic(1.0f, 1.0f, 1.0f));
    Settings settings = small_settings(4, 0.002f, 4096);
    settings.bounces = 200;
    const Result result = floor_under(scene, &white, settings);
    expect_light(result, glm::dvec3(1.0), 2e-3);
}

// A roof that the sun shines on throws a shadow beside itself, is lit itself, and nothing of that is there twice.
TEST(OneSided, ARoofInTheSunThrowsAShadow)
{
    const scene::Material matte = phong(glm::vec3(0.5f), glm::vec3(0.0f), 1.0f);
    scene::Scene scene = scene_of(facing_square(20.0f, 0.0f), matte);
    add(scene, facing_square(0.25f, 0.5f), matte, glm::translate(glm::mat4(1.0f), {-0.5f, 0.0f, 0.0f}));
    scene::Light sun;
    sun.kind = scene::LightKind::directional;
    sun.direction = glm::normalize(glm::vec3(1.0f, 0.0f, -1.0f));
    sun.intensity = glm::vec3(2.0f);
    Settings settings = small_settings(16, 2.0f, 8);
    settings.model = view::Model::phong;
    settings.bounces = 1;
    settings.lights = {sun};
    const Result result = trace(scene, nullptr, settings);
    // Pixels of an eighth of a metre: the roof is 2..5, its shadow 6..9.
    const double open = average(result, {12, 7, 4, 2}, 0).mean;
    EXPECT_EQ(average(result, {7, 7, 2, 2}, 0).mean, 0.0);
    EXPECT_NEAR(average(result, {3, 7, 2, 2}, 0).mean, open, 1e-6 * open);
    EXPECT_GT(open, 0.5 / pi * 2.0 * std::sqrt(0.5) * 0.999);
}

// Lamps and unlit pictures: their backs send nothing, and are in the way.
TEST(OneSided, BacksDoNotShine)
{
    scene::Material lamp = metallic(0.0f, 1.0f, 1.0f);
    lamp.emissive = glm::vec3(2.0f);
    Settings settings = small_settings(4, 0.002f, 64);
    settings.bounces = 3;
    for (const scene::Material& roof : {lamp, unlit(glm::vec3(2.0f))})
        for (const Strategy strategy : all_strategies) {
            settings.strategy = strategy;
            const Result result = floor_under(below(metallic(0.5f, 0.0f, 1.0f), roof), nullptr, settings);
            EXPECT_EQ(average(result, whole(result), 0).mean, 0.0) << static_cast<int>(strategy);
        }
}

// A room of which the camera sees the inside through the back of its wall is as dark as with walls on both sides.
TEST(OneSided, ARoomSeenThroughItsWallKeepsTheSkyOut)
{
    const image::RadianceImage white = white_panorama();
    scene::Scene scene = scene_of(scene::make_sphere(1.0f, 64, 32), metallic(0.8f, 0.0f, 1.0f));
    for (glm::uvec3& triangle : scene.meshes[0].triangles)
        std::swap(triangle.y, triangle.z);
    for (glm::vec3& normal : scene.meshes[0].normals)
        normal = -normal;
    Settings settings = small_settings(8, 0.5f, 32);
    settings.bounces = 4;
    const Result result = trace(scene, &white, settings);
    EXPECT_EQ(average(result, whole(result), 3).mean, 1.0);
    EXPECT_EQ(average(result, whole(result), 0).mean, 0.0);
}

} // namespace
} // namespace lambent::reference
