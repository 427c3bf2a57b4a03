// Pictures with bounces against the path tracer of src/reference, which shares none of their code but the equations.
#include "reference/tracer.h"
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>

#include <cmath>
#include <string>

namespace lambent::draw::testing {
namespace {

struct Case {
    std::string name;
    scene::Scene scene;
    Settings settings;
    bool dark = false; ///< no environment
    double most = 0.0; ///< relative RMSE that the filter may leave at these few samples
};

void PrintTo(const Case& c, std::ostream* out)
{
    *out << c.name;
}

scene::Material surface(glm::vec3 color, float metallic, float roughness)
{
    scene::Material material;
    material.base_color = glm::vec4(color, 1.0f);
    material.metallic = metallic;
    material.perceptual_roughness = roughness;
    return material;
}

// A floor, a wall and a sphere in their corner.
scene::Scene corner(const scene::Material& sphere)
{
    scene::Scene scene;
    scene::Material plain = surface({0.7f, 0.6f, 0.5f}, 0.0f, 0.9f);
    plain.double_sided = true;
    add(scene, facing_square(1.0f, -0.5f), plain);
    add(scene, facing_square(1.0f, 0.5f), surface({0.3f, 0.6f, 0.8f}, 0.0f, 0.6f),
        glm::rotate(glm::mat4(1.0f), -1.5707963f, {1.0f, 0.0f, 0.0f}) *
            glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, -1.0f}));
    add(scene, scene::make_sphere(0.3f, 48, 24), sphere,
        glm::translate(glm::mat4(1.0f), {-0.1f, -0.2f, 0.1f}));
    return scene;
}

Settings view()
{
    Settings settings = small_settings(60, 45, front_camera(1.7f));
    settings.bounces = 8;
    settings.passes = 8;
    return settings;
}

image::RadianceImage sky()
{
    image::RadianceImage image{64, 32, 3, {}};
    image.values.resize(64 * 32 * 3);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            const float up = 1.0f - static_cast<float>(y) / 16.0f;
            const bool lamp = x >= 20 && x < 24 && y >= 6 && y < 9;
            for (int c = 0; c < 3; ++c)
                image.pixel(x, y)[c] = lamp ? 40.0f : 0.6f + 0.3f * up + 0.1f * static_cast<float>(c) * up;
        }
    return image;
}

std::vector<Case> cases()
{
    std::vector<Case> all;
    const scene::Material red = surface({0.8f, 0.2f, 0.1f}, 0.0f, 0.4f);
    all.push_back({"sky", corner(red), view(), false, 0.06});
    all.push_back({"metal", corner(surface({0.9f, 0.7f, 0.3f}, 1.0f, 0.4f)), view(), false, 0.09});
    scene::Material coated = red;
    coated.coat = 1.0f;
    coated.coat_roughness = 0.1f;
    all.push_back({"coat", corner(coated), view(), false, 0.05});
    Settings once = view();
    once.bounces = 1;
    all.push_back({"one_bounce", corner(red), once, false, 0.05});
    Settings twice = view();
    twice.bounces = 2;
    all.push_back({"two_bounces", corner(red), twice, false, 0.05});
    scene::Light lamp;
    lamp.position = {0.7f, 0.6f, 0.9f};
    lamp.intensity = {4.0f, 3.0f, 2.0f};
    Settings lit = view();
    lit.lights = {lamp};
    all.push_back({"point_light", corner(red), lit, true, 0.05});
    scene::Material glow = surface({0.1f, 0.1f, 0.1f}, 0.0f, 0.9f);
    glow.emissive = {3.0f, 4.0f, 5.0f};
    all.push_back({"emission", corner(glow), view(), true, 0.25});
    Settings turned = view();
    turned.environment_rotation = 2.0f;
    all.push_back({"rotation", corner(red), turned, false, 0.06});
    scene::Scene mirrored = corner(red);
    mirrored.instances.back().transform =
        glm::scale(mirrored.instances.back().transform, {-0.8f, 1.0f, 1.1f});
    mirrored.instances.push_back(mirrored.instances.back());
    mirrored.instances.back().transform[3] = {0.5f, -0.3f, 0.3f, 1.0f};
    all.push_back({"mirrored_instances", mirrored, view(), false, 0.05});
    return all;
}

class FullLight : public ::testing::TestWithParam<Case> {};

struct Comparison {
    double mean = 0.0, error = 0.0; ///< of the picture over the reference's; relative RMSE, cut at 1
};

Comparison compared(const image::RadianceImage& picture, const reference::Result& truth)
{
    double sum = 0.0, wanted = 0.0, squares = 0.0, noise = 0.0, cut = 0.0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            if (!(truth.radiance.pixel(x, y)[3] > 0.0f))
                continue;
            for (int c = 0; c < 3; ++c) {
                const double a = picture.pixel(x, y)[c], b = truth.radiance.pixel(x, y)[c];
                sum += a, wanted += b;
                const double off = std::min(a, 1.0) - std::min(b, 1.0);
                squares += off * off;
                cut += std::min(b, 1.0);
                if (b < 1.0)
                    noise += truth.variance.pixel(x, y)[c];
            }
        }
    const double pixels = static_cast<double>(picture.width) * picture.height * 3.0;
    return {sum / wanted, std::sqrt(std::max(squares - noise, 0.0) / pixels) / (cut / pixels)};
}

TEST_P(FullLight, IsThatOfThePathTracer)
{
    const Case& c = GetParam();
    const image::RadianceImage panorama = sky();
    reference::Settings asked;
    static_cast<view::Picture&>(asked) = c.settings;
    asked.bounces = c.settings.bounces;
    asked.samples = 512;
    const reference::Result truth = reference::trace(c.scene, c.dark ? nullptr : &panorama, asked);
    const environment::Environment environment =
        environment::make_environment(environment::make_panorama(panorama));
    const Frame frame = draw(c.scene, c.dark ? nullptr : &environment, c.settings);
    const Comparison found = compared(frame.radiance, truth);
    EXPECT_NEAR(found.mean, 1.0, 0.015);
    EXPECT_LT(found.error, c.most);
    RecordProperty("error", std::to_string(found.error));
    std::printf("%s: mean %.4f, relative RMSE %.4f\n", c.name.c_str(), found.mean, found.error);
    // Without bounces the picture is another.
    Settings unshadowed = c.settings;
    unshadowed.bounces = 0;
    const Frame before = draw(c.scene, c.dark ? nullptr : &environment, unshadowed);
    EXPECT_GT(compared(before.radiance, truth).error, 1.5 * found.error);
}

INSTANTIATE_TEST_SUITE_P(Scenes, FullLight, ::testing::ValuesIn(cases()),
                         [](const auto& info) { return info.param.name; });

} // namespace
} // namespace lambent::draw::testing
