// A white body under light that is the same from everywhere cannot be told from it.
#include "tests/reference/traced.h"

namespace lambent::reference {
namespace {

using namespace testing;

struct Furnace {
    float metalness, roughness;
    int bounces;
};

// Of the body itself the middle and up to 8 degrees from its rim.
Result heated(const Furnace& furnace, bool compensated = true)
{
    const scene::Scene scene =
        scene_of(scene::make_sphere(1.0f, 256, 128), metallic(1.0f, furnace.metalness, furnace.roughness));
    const image::RadianceImage light = white_panorama();
    Settings settings = small_settings(16, 1.4f, 64);
    settings.bounces = furnace.bounces;
    settings.energy_compensation = compensated;
    return trace(scene, &light, settings);
}

// The table that light is given back by is read between its entries: within 0.3%.
constexpr double table_error = 3e-3;

TEST(ReferenceFurnace, AWhiteBodyDisappears)
{
    for (const float metalness : {0.0f, 0.5f, 1.0f})
        for (const float roughness : {0.0f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f})
            for (const int bounces : {1, 8}) {
                SCOPED_TRACE(::testing::Message() << "metalness " << metalness << ", roughness " << roughness
                                                  << ", bounces " << bounces);
                const Result result = heated({metalness, roughness, bounces});
                expect_light(result, glm::dvec3(1.0), table_error);
                // Noise must not be what makes them agree.
                EXPECT_LT(average(result, whole(result), 0).deviation, 4e-3);
                EXPECT_EQ(result.radiance.pixel(7, 7)[3], 1.0f);
            }
}

TEST(ReferenceFurnace, AWhiteBodyInACoatDisappears)
{
    for (const float roughness : {0.0f, 0.5f})
        for (const float metalness : {0.0f, 1.0f}) {
            scene::Scene scene =
                scene_of(scene::make_sphere(1.0f, 256, 128), metallic(1.0f, metalness, 0.4f));
            scene.materials[0].coat = 1.0f;
            scene.materials[0].coat_roughness = roughness;
            const image::RadianceImage light = white_panorama();
            expect_light(trace(scene, &light, small_settings(16, 1.4f, 64)), glm::dvec3(1.0), table_error);
        }
}

// Nothing that is always 1 would pass: a rough metal without compensation is dark.
TEST(ReferenceFurnace, RoughMetalLosesLightWithoutCompensation)
{
    const Result result = heated({1.0f, 1.0f, 4}, false);
    EXPECT_LT(average(result, whole(result), 1).mean, 0.75);
    EXPECT_GT(average(result, whole(result), 1).mean, 0.3);
}

} // namespace
} // namespace lambent::reference
