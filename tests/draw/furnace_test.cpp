// The white furnace: what reflects everything cannot be told from a white environment.
#include "scene/builtin/builtin.h"
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace lambent::draw {
namespace {

struct Extremes {
    float least = 1e9f, most = 0.0f;
    int pixels = 0;
};

// Over the pixels that only the surface covers.
Extremes extremes(const Frame& frame)
{
    Extremes e;
    for (std::size_t i = 0; i < frame.radiance.values.size(); i += 4) {
        if (frame.radiance.values[i + 3] < 0.999f)
            continue;
        ++e.pixels;
        for (std::size_t c = 0; c < 3; ++c) {
            e.least = std::min(e.least, frame.radiance.values[i + c]);
            e.most = std::max(e.most, frame.radiance.values[i + c]);
        }
    }
    return e;
}

scene::Scene white_sphere(float roughness)
{
    scene::Scene scene;
    scene::Material material;
    material.metallic = 1.0f;
    material.perceptual_roughness = roughness;
    testing::add(scene, scene::make_sphere(0.5f, 64, 32), material);
    return scene;
}

float mean_of_sphere(float roughness, bool compensation)
{
    const scene::Scene scene = white_sphere(roughness);
    Settings settings = testing::small_settings(64, 64, testing::front_camera(1.1f));
    settings.energy_compensation = compensation;
    const environment::Environment white = testing::white_environment();
    const Frame frame = testing::draw(scene, &white, settings);
    double sum = 0.0, pixels = 0.0;
    for (std::size_t i = 0; i < frame.radiance.values.size(); i += 4) {
        sum += frame.radiance.values[i];
        pixels += frame.radiance.values[i + 3];
    }
    return static_cast<float>(sum / pixels);
}

// What a white metal of alpha = 1 reflects by single scattering, averaged over a sphere's disc, by quadrature over
// light directions. At alpha = 1, D = 1 / pi; the masking is Smith's, height-correlated. [Heitz 2014, eq. 72, 99]
double albedo_of_disc()
{
    constexpr int steps = 64;
    const auto lambda = [](double c) { return (1.0 / c - 1.0) / 2.0; };
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double cos_v = (i + 0.5) / steps;
        double reflected = 0.0;
        for (int j = 0; j < steps; ++j) {
            const double cos_l =
                (j + 0.5) / steps; // uniform in solid angle; D and G do not depend on the azimuth
            const double f =
                1.0 / std::numbers::pi / (1.0 + lambda(cos_v) + lambda(cos_l)) / (4.0 * cos_v * cos_l);
            reflected += f * cos_l * 2.0 * std::numbers::pi / steps;
        }
        sum += reflected * 2.0 * cos_v / steps;
    }
    return sum;
}

TEST(Furnace, EverySphereIsOneAtEveryRoughnessAndMetalness)
{
    const environment::Environment white = testing::white_environment();
    const scene::Scene scene = scene::make_builtin("furnace");
    Settings settings;
    settings.width = 640;
    settings.height = 360;
    settings.camera = orbit_camera(scene::bounds(scene), {}, 0.7853982f, 640.0f / 360.0f);
    for (int samples : {1, 7, 40, 200}) {
        settings.samples = samples;
        const Extremes e = extremes(testing::draw(scene, &white, settings));
        EXPECT_GT(e.pixels, 20000);
        EXPECT_GT(e.least, 0.995f) << samples << " samples";
        EXPECT_LT(e.most, 1.005f) << samples << " samples";
    }
}

// What a coat does not send back itself reaches the white metal below it, and comes out again.
TEST(Furnace, ACoatKeepsASphereOne)
{
    const environment::Environment white = testing::white_environment();
    for (const float roughness : {0.0f, 0.3f, 1.0f})
        for (const float coat : {0.5f, 1.0f}) {
            scene::Scene scene = white_sphere(0.4f);
            scene.materials[0].coat = coat;
            scene.materials[0].coat_roughness = roughness;
            const Extremes e = extremes(
                testing::draw(scene, &white, testing::small_settings(64, 64, testing::front_camera(1.1f))));
            EXPECT_GT(e.least, 0.995f) << "coat " << coat << ", roughness " << roughness;
            EXPECT_LT(e.most, 1.005f) << "coat " << coat << ", roughness " << roughness;
        }
}

// A black body in a coat of lacquer: its reflectance head on is that of an index of 1.5. [Fresnel]
TEST(Furnace, ACoatOverBlackMirrorsAFewPercent)
{
    const environment::Environment white = testing::white_environment();
    scene::Scene scene = white_sphere(0.0f);
    scene::Material& m = scene.materials[0];
    m.base_color = {0.0f, 0.0f, 0.0f, 1.0f};
    const auto middle = [&](float coat) {
        m.coat = coat;
        const Frame frame =
            testing::draw(scene, &white, testing::small_settings(64, 64, testing::front_camera(1.1f)));
        return frame.radiance.pixel(32, 32)[1];
    };
    EXPECT_NEAR(middle(0.0f), 0.0f, 1e-3f);
    EXPECT_NEAR(middle(1.0f), 0.04f, 1e-3f);
    EXPECT_NEAR(middle(0.5f), 0.02f, 1e-3f);
}

TEST(Furnace, WithoutCompensationRoughMetalLosesWhatTheTableSays)
{
    std::printf("roughness   compensated   single scattering\n");
    float before = 1.0f;
    for (float roughness : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f}) {
        const float with = mean_of_sphere(roughness, true), without = mean_of_sphere(roughness, false);
        std::printf("%9.2f   %11.4f   %17.4f\n", static_cast<double>(roughness), static_cast<double>(with),
                    static_cast<double>(without));
        EXPECT_NEAR(with, 1.0f, 0.002f);
        EXPECT_LE(without, before + 1e-3f);
        before = without;
    }
    EXPECT_NEAR(before, albedo_of_disc(), 0.01);
}

} // namespace
} // namespace lambent::draw
