// Lights without size on tilted surfaces, against closed forms and against GGX written from slopes.
#include "tests/draw/test_scenes.h"
#include "tests/equations/reference_ggx.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambent::draw {
namespace {

using glm::dvec3;
using test::pi;
using testing::matte;
using testing::pixel;

scene::Light sunlight(dvec3 towards_light, glm::vec3 lux)
{
    scene::Light light;
    light.kind = scene::LightKind::directional;
    light.direction = glm::vec3(-towards_light);
    light.intensity = lux;
    return light;
}

scene::Light lamp_at(dvec3 position, glm::vec3 candela)
{
    scene::Light light;
    light.position = glm::vec3(position);
    light.intensity = candela;
    return light;
}

// What is seen from +Z of a square at the origin that is turned by `angle` to the right.
glm::dvec4 seen(const scene::Material& material, double angle, const scene::Light& light, Settings settings)
{
    scene::Scene scene;
    testing::add(scene, testing::facing_square(1.0f, 0.0f), material,
                 glm::rotate(glm::mat4(1.0f), static_cast<float>(angle), glm::vec3(0, 1, 0)));
    settings.lights = {light};
    return pixel(testing::draw(scene, nullptr, settings), 1, 1);
}

Settings settings_of(Model model)
{
    Settings settings = testing::small_settings(3, 3, testing::front_camera(0.01f));
    settings.model = model;
    return settings;
}

TEST(DirectLight, FallsWithTheCosine)
{
    const scene::Material material = matte({0.5f, 0.25f, 0.75f});
    for (double degrees : {-60.0, 60.0}) {
        const double angle = degrees * pi / 180.0;
        const dvec3 towards(std::sin(angle), 0.0, std::cos(angle));
        for (const scene::Light& light :
             {sunlight(towards, {3.0f, 2.0f, 1.0f}), lamp_at(2.0 * towards, {12.0f, 8.0f, 4.0f})}) {
            const glm::dvec4 c = seen(material, 0.0, light, settings_of(Model::phong));
            EXPECT_NEAR(c.r, 0.5 * 3.0 / pi * 0.5, 1e-4) << degrees;
            EXPECT_NEAR(c.g, 0.25 * 2.0 / pi * 0.5, 1e-4) << degrees;
            EXPECT_NEAR(c.b, 0.75 * 1.0 / pi * 0.5, 1e-4) << degrees;
        }
    }
}

TEST(DirectLight, FromBehindIsNone)
{
    const dvec3 behind = dvec3(std::sqrt(0.75), 0.0, -0.5);
    for (const Model model : {Model::phong, Model::ggx})
        for (const float metalness : {0.0f, 1.0f})
            for (const scene::Light& light :
                 {sunlight(behind, glm::vec3(3.0f)), lamp_at(behind, glm::vec3(3.0f))}) {
                scene::Material material;
                material.metallic = metalness;
                material.perceptual_roughness = 0.7f;
                const glm::dvec4 c = seen(material, 0.0, light, settings_of(model));
                EXPECT_EQ(c.r, 0.0);
                EXPECT_EQ(c.a, 1.0);
            }
}

// A surface seen at NV = 0.8 and lit at NL = 0.5 from a side.
struct Tilted {
    double angle = std::acos(0.8);
    dvec3 N{std::sin(angle), 0.0, std::cos(angle)}, V{0.0, 0.0, 1.0}, L;

    explicit Tilted(double azimuth)
    {
        const dvec3 across(std::cos(angle), 0.0, -std::sin(angle)), up(0.0, 1.0, 0.0);
        L = 0.5 * N + std::sqrt(0.75) * (std::cos(azimuth) * across + std::sin(azimuth) * up);
    }
};

// D G2 F / (4 NV): the BRDF times NL.
double ggx(const Tilted& t, double alpha, double F0)
{
    const dvec3 H = glm::normalize(t.L + t.V);
    const double F = F0 + (1.0 - F0) * std::pow(1.0 - glm::dot(t.V, H), 5.0);
    const double G2 = 1.0 / (1.0 + test::smith_lambda(0.8, alpha) + test::smith_lambda(0.5, alpha));
    return test::facet_density(glm::dot(t.N, H), alpha) * G2 * F / (4.0 * 0.8);
}

constexpr double azimuths[] = {0.4, 2.0, 3.14159, 5.0};
constexpr double roughnesses[] = {0.3, 0.6, 1.0};

TEST(DirectLight, OfAColouredMetalIsGgx)
{
    Settings settings = settings_of(Model::ggx);
    settings.energy_compensation = false;
    for (const double azimuth : azimuths)
        for (const double roughness : roughnesses) {
            const Tilted t(azimuth);
            scene::Material metal;
            metal.base_color = {1.0f, 0.5f, 0.2f, 1.0f};
            metal.perceptual_roughness = static_cast<float>(roughness);
            for (const scene::Light& light :
                 {sunlight(t.L, {3.0f, 2.0f, 5.0f}), lamp_at(2.0 * t.L, {12.0f, 8.0f, 20.0f})}) {
                const glm::dvec4 c = seen(metal, t.angle, light, settings);
                const double alpha = roughness * roughness;
                EXPECT_NEAR(c.r / (3.0 * ggx(t, alpha, 1.0)), 1.0, 5e-4) << roughness << ' ' << azimuth;
                EXPECT_NEAR(c.g / (2.0 * ggx(t, alpha, 0.5)), 1.0, 5e-4) << roughness << ' ' << azimuth;
                EXPECT_NEAR(c.b / (5.0 * ggx(t, alpha, 0.2)), 1.0, 5e-4) << roughness << ' ' << azimuth;
            }
        }
}

// Over black, a dielectric reflects by its facets alone.
TEST(DirectLight, OfABlackDielectricIsGgx)
{
    Settings settings = settings_of(Model::ggx);
    settings.energy_compensation = false;
    for (const double azimuth : azimuths)
        for (const double roughness : roughnesses) {
            const Tilted t(azimuth);
            scene::Material black;
            black.metallic = 0.0f;
            black.base_color = {0.0f, 0.0f, 0.0f, 1.0f};
            black.perceptual_roughness = static_cast<float>(roughness);
            const glm::dvec4 c = seen(black, t.angle, sunlight(t.L, glm::vec3(3.0f)), settings);
            EXPECT_NEAR(c.g / (3.0 * ggx(t, roughness * roughness, 0.04)), 1.0, 5e-4)
                << roughness << ' ' << azimuth;
        }
}

// What a white metal reflects of uniform light at NV = 0.8 by single scattering: the mean over light directions.
double albedo_at(double alpha)
{
    constexpr int steps = 200;
    const dvec3 V(0.6, 0.0, 0.8);
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const double z = (i + 0.5) / steps, r = std::sqrt(1.0 - z * z), phi = pi * (j + 0.5) / steps;
            const dvec3 L(r * std::cos(phi), r * std::sin(phi), z);
            const double G2 = 1.0 / (1.0 + test::smith_lambda(0.8, alpha) + test::smith_lambda(z, alpha));
            sum += test::facet_density(glm::normalize(L + V).z, alpha) * G2 / (4.0 * 0.8);
        }
    return sum * 2.0 * pi / (steps * steps);
}

// What facets reflect more than once comes back as 1 + F0 (1 - E) / E. [Turquin 2019]
TEST(DirectLight, CompensationMultipliesIt)
{
    for (const double roughness : {0.6, 1.0}) {
        const Tilted t(2.0);
        scene::Material metal;
        metal.base_color = {1.0f, 0.5f, 0.0f, 1.0f};
        metal.perceptual_roughness = static_cast<float>(roughness);
        const scene::Light light = sunlight(t.L, glm::vec3(3.0f));
        const glm::dvec4 with = seen(metal, t.angle, light, settings_of(Model::ggx));
        Settings without = settings_of(Model::ggx);
        without.energy_compensation = false;
        const glm::dvec4 once = seen(metal, t.angle, light, without);
        const double E = albedo_at(roughness * roughness);
        EXPECT_NEAR(with.r / once.r, 1.0 + (1.0 - E) / E, 0.003) << roughness;
        EXPECT_NEAR(with.g / once.g, 1.0 + 0.5 * (1.0 - E) / E, 0.003) << roughness;
        EXPECT_NEAR(with.b / once.b, 1.0, 1e-5) << roughness;
    }
}

// The mean of D over normals whose slopes fill a square of side `bend`, near the pole: alpha^2 / (pi (alpha^2 + slope^2)^2).
double density_over_slopes(double alpha, double bend)
{
    constexpr int steps = 400;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const double x = bend * ((i + 0.5) / steps - 0.5), y = bend * ((j + 0.5) / steps - 0.5);
            sum += alpha * alpha / (pi * std::pow(alpha * alpha + x * x + y * y, 2.0));
        }
    return sum / (steps * steps);
}

// A sphere whose normals turn by `bend` from pixel to pixel, lit and seen head on, where G2 = F0 = 1: D / 4. Of highlights
// from a tenth of a pixel's width to all of it, a little of the narrowest is missed, which is in the middle of four looks.
TEST(DirectLight, HighlightsNarrowerThanAPixelFillIt)
{
    scene::Scene scene;
    scene::Material metal;
    metal.perceptual_roughness = 0.1f;
    testing::add(scene, scene::make_sphere(0.5f, 512, 256), metal);
    for (const int size : {9, 17, 33, 65, 129}) {
        Settings settings = testing::small_settings(size, size, testing::front_camera(1.0f));
        settings.energy_compensation = false;
        settings.lights = {sunlight({0, 0, 1}, glm::vec3(1.0f))};
        const double wanted = 0.25 * density_over_slopes(0.01, 1.0 / size / 0.5);
        const auto middle =
            static_cast<double>(pixel(testing::draw(scene, nullptr, settings), size / 2, size / 2).r);
        EXPECT_NEAR(middle / wanted, 1.0, size < 10 ? 0.25 : 0.08) << size;
    }
}

} // namespace
} // namespace lambent::draw
