// What camera rays meet first: known scenes, and light that stays the same whether it is asked for or not.
#include "tests/reference/traced.h"

#include <gtest/gtest.h>

namespace lambent::reference::testing {
namespace {

Result traced_with_firsts(const scene::Scene& scene, const image::RadianceImage* panorama, Settings settings)
{
    settings.first_surfaces = true;
    Result result = trace(scene, panorama, settings);
    EXPECT_TRUE(result.first_surfaces.has_value());
    return result;
}

// In the white furnace a surface without shadows shines by its directional albedo.
TEST(ReferenceFirstSurface, AlbedoIsTheLightOfTheWhiteFurnace)
{
    const image::RadianceImage white = white_panorama();
    for (const float metalness : {0.0f, 0.3f, 1.0f})
        for (const float coat : {0.0f, 0.8f}) {
            scene::Material material = metallic(0.6f, metalness, 0.5f);
            material.base_color.g = 0.2f;
            material.coat = coat;
            Settings settings = small_settings(8, 1.0f, 64);
            settings.bounces = 0;
            const Result result =
                traced_with_firsts(scene_of(facing_square(2.0f, 0.0f), material), &white, settings);
            for (int c = 0; c < 3; ++c) {
                double albedo = 0.0;
                for (int i = 0; i < 64; ++i)
                    albedo += static_cast<double>(result.first_surfaces->albedo.pixel(i % 8, i / 8)[c]) / 64;
                expect_light(average(result, whole(result), c), albedo, 5e-3);
            }
        }
}

TEST(ReferenceFirstSurface, NormalAndDepthAreThoseOfTheSquare)
{
    const Result result = traced_with_firsts(scene_of(facing_square(2.0f, 3.0f), metallic(0.5f, 0.0f, 0.5f)),
                                             nullptr, small_settings(4, 1.0f, 3));
    EXPECT_NEAR(result.first_surfaces->normal.pixel(2, 1)[2], 1.0, 1e-5);
    EXPECT_NEAR(result.first_surfaces->normal.pixel(2, 1)[0], 0.0, 1e-5);
    EXPECT_NEAR(result.first_surfaces->depth[5], 7.0, 1e-4);
    EXPECT_EQ(result.first_surfaces->samples, std::vector<int>(16, 3));
}

// Emission, unlit colour and a sharp background are the light itself; there is nothing else.
TEST(ReferenceFirstSurface, LightThatIsNotReflectedIsEmitted)
{
    scene::Material emissive = metallic(0.0f, 1.0f, 0.5f);
    emissive.emissive = {0.5f, 2.0f, 3.0f};
    const image::RadianceImage white = white_panorama();
    for (const scene::Material& material : {emissive, unlit({0.1f, 0.4f, 0.7f})}) {
        Settings settings = small_settings(6, 4.0f, 5);
        settings.background.kind = view::Background::Kind::environment;
        settings.bounces = 1;
        const bool is_unlit = material.unlit;
        const Result result = traced_with_firsts(scene_of(facing_square(1.0f, 0.0f), material),
                                                 is_unlit ? &white : nullptr, settings);
        for (int i = 0; i < 36; ++i)
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(result.first_surfaces->emitted.pixel(i % 6, i / 6)[c],
                            result.radiance.pixel(i % 6, i / 6)[c], 1e-6);
    }
}

// A blurred background is noisy, and left to the filter.
TEST(ReferenceFirstSurface, ABlurredBackgroundIsNotKnown)
{
    const image::RadianceImage white = white_panorama();
    Settings settings = small_settings(4, 1.0f, 2);
    settings.background.kind = view::Background::Kind::blurred;
    settings.background.roughness = 0.5f;
    const Result result = traced_with_firsts(scene_of(facing_square(0.1f, 20.0f), metallic(0.5f, 0.0f, 0.5f)),
                                             &white, settings);
    EXPECT_EQ(result.first_surfaces->emitted.pixel(1, 1)[0], 0.0f);
    EXPECT_EQ(result.first_surfaces->albedo.pixel(1, 1)[0], 1.0f);
    EXPECT_EQ(result.first_surfaces->depth[0], 0.0f);
}

TEST(ReferenceFirstSurface, TheLightIsTheSameWithoutThem)
{
    const image::RadianceImage white = white_panorama();
    const scene::Scene scene = scene_of(facing_square(0.7f, 0.0f), metallic(0.6f, 0.5f, 0.4f));
    const Settings settings = small_settings(20, 2.0f, 6);
    const Result plain = trace(scene, &white, settings), asked = traced_with_firsts(scene, &white, settings);
    EXPECT_FALSE(plain.first_surfaces.has_value());
    EXPECT_EQ(plain.radiance.values, asked.radiance.values);
    EXPECT_EQ(plain.variance.values, asked.variance.values);
}

// A lamp far away lights a flat surface evenly: at its edge the light varies as the coverage does, and not for its albedo.
TEST(ReferenceFirstSurface, HowMuchIsCoveredIsNoNoiseOfTheLight)
{
    Settings settings = small_settings(5, 1.0f, 24);
    scene::Light lamp;
    lamp.kind = scene::LightKind::directional;
    lamp.direction = {0.0f, 0.0f, -1.0f};
    settings.lights = {lamp};
    const Result result = traced_with_firsts(scene_of(facing_square(0.39f, 0.0f), metallic(0.5f, 0.0f, 0.9f)),
                                             nullptr, settings);
    EXPECT_GT(result.radiance.pixel(0, 2)[3], 0.1f);
    EXPECT_LT(result.radiance.pixel(0, 2)[3], 0.9f);
    const float light = result.radiance.pixel(0, 2)[1];
    EXPECT_GT(result.variance.pixel(0, 2)[1], 1e-5f * light * light);
    EXPECT_LT(result.first_surfaces->variance.pixel(0, 2)[1], 1e-9f * light * light);
}

// A light that is noisy has the same variance in both ways of counting where the albedo is the same everywhere.
TEST(ReferenceFirstSurface, VarianceIsThatOfTheLightWhereTheAlbedoIsEven)
{
    const image::RadianceImage panorama =
        panorama_of(16, [](const glm::dvec3& d) { return glm::dvec3(1.0 + d.x, 1.0, 1.0 - d.x * d.z); });
    const Result result = traced_with_firsts(scene_of(facing_square(2.0f, 0.0f), metallic(0.5f, 0.0f, 1.0f)),
                                             &panorama, small_settings(6, 1.0f, 10));
    for (int i = 0; i < 36; ++i) {
        const float expected = result.variance.pixel(i % 6, i / 6)[0];
        EXPECT_GT(expected, 0.0f);
        EXPECT_NEAR(result.first_surfaces->variance.pixel(i % 6, i / 6)[0], expected, 1e-3f * expected);
    }
}

} // namespace
} // namespace lambent::reference::testing
