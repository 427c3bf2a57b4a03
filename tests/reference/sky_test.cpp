// Surfaces under skies whose irradiance is known.
#include "tests/reference/closed_phong.h"
#include "tests/reference/traced.h"

namespace lambent::reference {
namespace {

using namespace testing;

constexpr double third_of_turn = 2.0 * pi / 3.0;

// Light 2 + x - y/2 + z: seen by a plane that faces +Z, x and y cancel.
Result plane_under_slope(const scene::Material& material, int bounces, float rotation = 0.0f)
{
    const image::RadianceImage sky = panorama_of(512, [](const glm::dvec3& d) {
        const double light = 2.0 + d.x - 0.5 * d.y + d.z;
        return glm::dvec3(light, 2.0 * light, 0.5 * light);
    });
    Settings settings = small_settings(16, 1.0f, 128);
    settings.model = view::Model::phong;
    settings.bounces = bounces;
    settings.environment_rotation = rotation;
    return trace(scene_of(facing_square(5.0f, 0.0f), material), &sky, settings);
}

TEST(ReferenceSky, ADiffusePlaneShowsTheIrradiance)
{
    const glm::vec3 diffuse(0.2f, 0.5f, 0.8f);
    for (const int bounces : {0, 1, 5}) {
        const Result result = plane_under_slope(phong(diffuse, glm::vec3(0.0f), 1.0f), bounces);
        const double times[3] = {1.0, 2.0, 0.5};
        for (int c = 0; c < 3; ++c) {
            // The diffuse part in closed form, E = 2 pi + 2/3 pi; of the rest only Schlick's rim, below 1%.
            const double Kd = static_cast<double>(diffuse[c]), closed = Kd / pi * (2.0 * pi + third_of_turn);
            const double rim = ClosedPhong{0.0, 0.0, 1.0}.head_on([](double z) { return 2.0 + z; });
            EXPECT_LT(rim, 0.01 * closed);
            expect_light(average(result, whole(result), c), times[c] * (closed + rim));
        }
    }
}

TEST(ReferenceSky, AGlossyPlaneShowsWhatQuadratureDoes)
{
    for (const float exponent : {1.0f, 10.0f, 100.0f, 1000.0f}) {
        const Result result = plane_under_slope(phong(glm::vec3(0.3f), glm::vec3(0.5f), exponent), 1);
        const double expected =
            ClosedPhong{static_cast<double>(0.3f), 0.5, static_cast<double>(exponent)}.head_on(
                [](double z) { return 2.0 + z; });
        expect_light(result, expected * glm::dvec3(1.0, 2.0, 0.5));
    }
}

// Turned a quarter counter-clockwise seen from above, what was at +X is at -Z, and what was at +Z is at +X.
TEST(ReferenceSky, RotationTurnsTheLight)
{
    const double rim = ClosedPhong{0.0, 0.0, 1.0}.head_on([](double z) { return 2.0 - z; });
    const Result result =
        plane_under_slope(phong(glm::vec3(0.5f), glm::vec3(0.0f), 1.0f), 1, static_cast<float>(0.5 * pi));
    expect_light(result, (0.5 * (2.0 - 2.0 / 3.0) + rim) * glm::dvec3(1.0, 2.0, 0.5));
}

// One half of all directions is white: E = pi/2 (1 + cos angle), the angle between its middle and the normal.
TEST(ReferenceSky, ASphereInHalfAWhiteWorldShadesLikeACosine)
{
    const image::RadianceImage half =
        panorama_of(256, [](const glm::dvec3& d) { return glm::dvec3(d.x > 0.0 ? 1.0 : 0.0); });
    // Seen from the front up to 32 degrees from the middle, where Schlick's rim adds less than 1e-4.
    const float extent = 0.74f;
    for (const double rotation : {0.0, 0.7, 0.5 * pi, pi, -0.5 * pi}) {
        SCOPED_TRACE(rotation);
        Settings settings = small_settings(16, extent, 128);
        settings.model = view::Model::phong;
        settings.bounces = 1;
        settings.environment_rotation = static_cast<float>(rotation);
        const scene::Scene scene =
            scene_of(scene::make_sphere(1.0f, 256, 128), phong(glm::vec3(0.8f), glm::vec3(0.0f), 1.0e6f));
        const Result result = trace(scene, &half, settings);
        for (int column = 0; column < 16; ++column) {
            double expected = 0.0;
            for (int row = 0; row < 16; ++row) {
                const double x = ((column + 0.5) / 16.0 - 0.5) * static_cast<double>(extent);
                const double y = ((row + 0.5) / 16.0 - 0.5) * static_cast<double>(extent);
                const double z = std::sqrt(1.0 - x * x - y * y);
                // The middle of the white half, turned about +Y.
                expected += 0.8 * 0.5 * (1.0 + x * std::cos(rotation) - z * std::sin(rotation)) / 16.0;
            }
            const Average seen = average(result, {column, 0, 1, 16}, 1);
            EXPECT_NEAR(seen.mean, expected, deviations * seen.deviation + 5e-4) << "column " << column;
        }
    }
}

} // namespace
} // namespace lambent::reference
