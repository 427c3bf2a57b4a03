// Scenes whose light is known in closed form.
#include "tests/reference/small_scenes.h"

#include "equations/in_double.h"

#include <gtest/gtest.h>

namespace lambent::reference {
namespace {

using namespace testing;
using std::numbers::pi;

// What reflects everything cannot be told from a white environment, however often light is reflected on the way.
TEST(KnownLight, TheWhiteFurnaceIsOneAfterAnyNumberOfBounces)
{
    const image::RadianceImage white = white_panorama();
    for (float metalness : {0.0f, 1.0f})
        for (float roughness : {0.0f, 0.3f, 0.7f, 1.0f}) {
            scene::Scene scene;
            add(scene, scene::make_sphere(0.5f, 128, 64), metallic(glm::vec3(1.0f), metalness, roughness));
            Settings settings = front_view(12, 0.6f, 512); // within the sphere's outline
            for (int bounces : {0, 1, 2, 4, 8}) {
                settings.bounces = bounces;
                const Mean m = mean_of(trace(scene, &white, settings));
                EXPECT_NEAR(m.value, 1.0, 0.003 + most_sigmas * m.error)
                    << metalness << " " << roughness << " " << bounces;
                EXPECT_LT(m.error, 0.005);
            }
        }
}

// The report's material with Ks = 0 reflects Kd / pi, and Schlick's (1 - VH)^5 of a highlight, which is taken off by
// quadrature over the hemisphere for a view along the normal.
double highlight_under(const std::function<double(double)>& radiance_by_cosine, double exponent)
{
    constexpr int steps = 20000;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double NL = (i + 0.5) / steps, VH = std::sqrt(0.5 * (1.0 + NL));
        const double D = (exponent + 2.0) / (2.0 * pi) * std::pow(VH, exponent);
        sum += 2.0 * pi / steps * NL * D * std::pow(1.0 - VH, 5.0) / (4.0 * VH * VH) * radiance_by_cosine(NL);
    }
    return sum;
}

scene::Material matte(float diffuse)
{
    scene::Material m;
    m.phong = {glm::vec3(diffuse), glm::vec3(0.0f), 50.0f};
    return m;
}

// Radiance a + b cos + c cos^2 above a horizontal square gives pi a + 2 pi b / 3 + pi c / 2 of irradiance.
TEST(KnownLight, AMattePlaneUnderASky)
{
    const double a = 0.5, b = 2.0, c = 3.0, albedo = 0.6;
    const auto sky = [&](double cosine) { return a + b * cosine + c * cosine * cosine; };
    const image::RadianceImage light =
        panorama(256, [&](glm::dvec3 d) { return glm::dvec3(d.z > 0.0 ? sky(d.z) : 7.0); });
    scene::Scene scene;
    add(scene, facing_square(1.0f), matte(static_cast<float>(albedo)));
    Settings settings = front_view(8, 0.1f, 2048);
    settings.model = view::Model::phong;
    const double expected =
        albedo / pi * (pi * a + 2.0 * pi * b / 3.0 + pi * c / 2.0) + highlight_under(sky, 50.0);
    for (int bounces : {0, 1, 8}) {
        settings.bounces = bounces;
        const Mean m = mean_of(trace(scene, &light, settings));
        EXPECT_NEAR(m.value, expected, 1e-3 * expected + most_sigmas * m.error) << bounces;
        EXPECT_LT(m.error, 0.003 * expected);
    }
}

// Light from the half space around +Y: irradiance pi (1 + cos) / 2 where cos is the normal's angle to +Y.
TEST(KnownLight, ASphereInAHalfWhiteEnvironment)
{
    const image::RadianceImage light =
        panorama(512, [](glm::dvec3 d) { return glm::dvec3(d.y > 0.0 ? 1.0 : 0.0); });
    scene::Scene scene;
    add(scene, scene::make_sphere(0.5f, 256, 128), matte(0.5f));
    Settings settings = front_view(9, 0.9f, 2048);
    settings.model = view::Model::phong;
    settings.bounces = 1;
    const Result result = trace(scene, &light, settings);
    for (int y = 2; y < 7;
         ++y) { // further out the highlight, which grows at grazing angles, is not negligible
        const double height =
            (4.0 - y) * 0.1; // of the middle column's pixel; the mean over it is nearly the middle's
        const double expected = 0.5 * 0.5 * (1.0 + height / 0.5);
        const double error = std::sqrt(static_cast<double>(result.variance.pixel(4, y)[0]));
        // The highlight is below one part in a thousand of white; the rest is the pixel's extent.
        EXPECT_NEAR(static_cast<double>(result.radiance.pixel(4, y)[0]), expected,
                    0.004 + most_sigmas * error)
            << y;
        EXPECT_LT(error, 0.01);
    }
}

// A sun of a few texels is a directional light of its illuminance: on a rough metal, where its size does not show.
TEST(KnownLight, ASmallSunIsADirectionalLight)
{
    constexpr int width = 1024, column = 700, row = 200;
    image::RadianceImage light = panorama(width, [](glm::dvec3) { return glm::dvec3(0.0); });
    for (int k = 0; k < 3; ++k)
        light.pixel(column, row)[k] = 1.0e5f;
    const in_double::vec3 d =
        in_double::direction_from_equirectangular({(column + 0.5) / width, (row + 0.5) / (width / 2)});
    // A texel between its neighbours is a tent: its integral is the texel's solid angle, to second order.
    const double solid = 2.0 * pi * pi / width / (width / 2) * std::sqrt(1.0 - d.y * d.y);
    scene::Scene scene;
    add(scene, scene::make_sphere(0.5f, 128, 64), metallic({0.9f, 0.6f, 0.3f}, 0.5f, 0.6f));
    Settings settings = front_view(24, 1.0f, 1024);
    settings.bounces = 1;
    const Result sun = trace(scene, &light, settings);
    scene::Light lamp;
    lamp.kind = scene::LightKind::directional;
    lamp.intensity = glm::vec3(static_cast<float>(1.0e5 * solid));
    lamp.direction = -glm::vec3(d.x, d.y, d.z);
    settings.lights = {lamp};
    const Result direct = trace(scene, nullptr, settings);
    for (int channel = 0; channel < 3; ++channel) {
        const Mean a = mean_of(sun, channel), b = mean_of(direct, channel);
        EXPECT_GT(b.value, 0.1);
        EXPECT_NEAR(a.value, b.value, 2e-3 * b.value + most_sigmas * std::hypot(a.error, b.error));
        EXPECT_LT(a.error, 0.005 * b.value);
    }
}

// A square of side 2 h at height d over a matte point under its middle: radiance L times the form factor
// 4 / (2 pi) (2 h' / sqrt(1 + h'^2) atan(h' / sqrt(1 + h'^2))), h' = h / d, of four right-angled quarters.
// [Howell 2010, configuration factor B-4]
TEST(KnownLight, AShiningSquareOverAMattePoint)
{
    const double half = 0.7, height = 0.5, ratio = half / height, root = std::sqrt(1.0 + ratio * ratio);
    const double factor = 4.0 / (2.0 * pi) * 2.0 * ratio / root * std::atan(ratio / root);
    scene::Scene scene;
    add(scene, facing_square(0.01f), matte(0.5f));
    scene::Material light = metallic(glm::vec3(0.0f), 1.0f, 1.0f);
    light.emissive = glm::vec3(2.0f);
    // Its front looks down; from above, where the camera is, it is not there.
    add(scene, facing_square(static_cast<float>(half)), light,
        glm::rotate(glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, height)), 3.14159265f,
                    glm::vec3(0, 1, 0)));
    Settings settings = front_view(4, 0.002f, 4096);
    settings.model = view::Model::phong;
    settings.bounces = 1;
    const double edge = height / std::hypot(height, half * std::sqrt(2.0)); // the least cosine: the corners'
    const double highlight = highlight_under([&](double cosine) { return cosine > edge ? 2.0 : 0.0; }, 50.0);
    for (Strategy strategy : {Strategy::both, Strategy::lights_only, Strategy::reflections_only}) {
        settings.strategy = strategy;
        const Mean m = mean_of(trace(scene, nullptr, settings));
        EXPECT_NEAR(m.value, 0.5 * 2.0 * factor, highlight + most_sigmas * m.error)
            << static_cast<int>(strategy);
        EXPECT_LT(m.error, 0.005);
        EXPECT_LT(highlight, 0.002);
    }
}

// Inside a closed white sphere that shines with Le, everything that is reflected comes back: Le (N + 1) after N bounces.
// With walls of black and white squares there would be less. Long paths end at random: that must not show.
TEST(KnownLight, InsideAShiningWhiteSphereEachBounceAddsTheSame)
{
    scene::Scene scene;
    scene::Material wall = metallic(glm::vec3(1.0f), 0.0f, 1.0f);
    wall.emissive = glm::vec3(0.25f);
    wall.double_sided = true;
    add(scene, scene::make_sphere(0.5f, 128, 64), wall);
    Settings settings;
    settings.panorama_from = glm::vec3(0.1f, 0.05f, -0.1f);
    settings.width = 16, settings.height = 8, settings.samples = 512;
    for (int bounces : {1, 2, 3, 5, 8, 30}) {
        settings.bounces = bounces;
        const Mean m = mean_of(trace(scene, nullptr, settings));
        // Rays that start flat along the triangles of a faceted sphere are lost: below one in a thousand per bounce.
        EXPECT_NEAR(m.value, 0.25 * (bounces + 1), 0.25 * 0.002 * bounces * bounces + most_sigmas * m.error)
            << bounces;
        EXPECT_LT(m.error, 0.01 * m.value);
    }
}

} // namespace
} // namespace lambent::reference
