// The report's own order of things in pictures: what its passes add up are codes.
#include "tests/draw/backend_checks.h"
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambent::draw::testing {
namespace {

using glm::dvec3;
using std::numbers::pi;

constexpr double exposure = 3.0, contrast = 1.2;

Settings report_settings(bool linear)
{
    Settings settings = small_settings(33, 33, front_camera(1.0f));
    settings.model = Model::phong;
    settings.mip_level = MipLevel::report;
    settings.texel_transfer = TexelTransfer::none;
    settings.ambient_brightness = 2.0f;
    settings.background.kind = Background::Kind::environment;
    settings.pipeline = ReportPipeline{static_cast<float>(exposure), static_cast<float>(contrast), linear};
    return settings;
}

double toned(double read, bool linear)
{
    const double c = exposure * std::pow(read, linear ? 2.2 : 1.0);
    return std::pow(c / (c + 1.0), linear ? contrast / 2.2 : contrast);
}

scene::Material shiny(float diffuse, float specular, float exponent)
{
    scene::Material material;
    material.phong = scene::PhongMaterial{glm::vec3(diffuse), glm::vec3(specular), exponent};
    return material;
}

} // namespace

// Radiance 0.7 from everywhere on a square that looks at the camera: the sky, diffuse^2.2 / pi times twice its toned
// irradiance, the root of a quarter of Ks times the toned sky, and of a lamp the BRDF, as it is.
void expect_the_reports_pipeline(const Draw& draw)
{
    constexpr double sky = 0.7, kd = 0.6, ks = 0.5, lux = 0.25;
    const environment::Environment even = environment_of(64, [](dvec3) { return glm::vec3(0.7f); });
    for (const bool linear : {true, false}) {
        const double gamma = linear ? 2.2 : 1.0;
        const double ambient = std::pow(kd, gamma) / pi * toned(pi * sky, linear) * 2.0;
        const double specular = std::pow(ks / 4.0 * toned(sky, linear), 1.0 / gamma);
        Settings settings = report_settings(linear);
        scene::Scene nothing, scene, dull;
        nothing.materials.emplace_back();
        EXPECT_NEAR(pixel(draw(nothing, &even, settings), 16, 16).g, toned(sky, linear), 2e-3);
        add(dull, facing_square(0.9f, 0.0f), shiny(0.6f, 0.0f, 1e5f));
        EXPECT_NEAR(pixel(draw(dull, &even, settings), 16, 16).g, ambient, 2e-3);
        add(scene, facing_square(0.9f, 0.0f), shiny(0.6f, 0.5f, 1e5f));
        EXPECT_NEAR(pixel(draw(scene, &even, settings), 16, 16).g, ambient + specular, 4e-3);
        scene::Light lamp;
        lamp.kind = scene::LightKind::directional;
        lamp.direction = {0.0f, -0.6f, -0.8f};
        lamp.intensity = glm::vec3(static_cast<float>(lux));
        settings.lights = {lamp};
        EXPECT_NEAR(pixel(draw(dull, &even, settings), 16, 16).g, ambient + kd / pi * lux * 0.8, 3e-3);
    }
}

// A mirror before a panorama of light and dark texels shows either, with nothing between: samples are read from the nearest
// texel, and those of so narrow a lobe all from one.
void expect_the_reports_blocks(const Draw& draw)
{
    constexpr int width = 64;
    const environment::Environment texels = environment_of(width, [](dvec3 d) {
        const int x = static_cast<int>((std::atan2(d.z, d.x) / (2.0 * pi) + 0.5) * width);
        const int y = static_cast<int>(std::acos(d.y) / pi * width / 2);
        return glm::vec3((x + y) % 2 == 0 ? 0.9f : 0.1f);
    });
    scene::Scene scene;
    add(scene, scene::make_sphere(0.5f, 256, 128), shiny(0.0f, 1.0f, 1e6f));
    Settings settings = report_settings(true);
    settings.camera = front_camera(0.2f);
    const Frame frame = draw(scene, &texels, settings);
    int light = 0, dark = 0;
    for (int y = 0; y < settings.height; ++y)
        for (int x = 0; x < settings.width; ++x) {
            const double value = static_cast<double>(pixel(frame, x, y).g);
            // F is 1, and 1 / (w.H)^2 nearly so in the middle of the sphere.
            light += std::fabs(value / std::pow(toned(0.9, true) / 4.0, 1.0 / 2.2) - 1.0) < 0.1;
            dark += std::fabs(value / std::pow(toned(0.1, true) / 4.0, 1.0 / 2.2) - 1.0) < 0.1;
        }
    EXPECT_GT(light, 350);
    EXPECT_GT(dark, 350);
    EXPECT_GT(light + dark, 850); // of 1089; the others are at the edges of texels
}

} // namespace lambent::draw::testing
