// Where rays of sight go, and what is seen where nothing is.
#include "tests/equations/quadrature.h"
#include "tests/reference/traced.h"

#include <glm/ext/matrix_transform.hpp>

namespace lambent::reference {
namespace {

using namespace testing;

// Something to trace that is out of sight.
scene::Scene nothing_near()
{
    return scene_of(facing_square(1.0f, -1000.0f), unlit({1.0f, 1.0f, 1.0f}));
}

// All different along all axes, and smooth: read between texels it is itself within 1e-3.
glm::dvec3 gradient(const glm::dvec3& d)
{
    return {1.0 + 0.9 * d.x, 1.0 + 0.9 * d.y, 1.0 + 0.9 * d.z};
}

TEST(ReferencePicture, APanoramaOfNothingIsTheEnvironment)
{
    const image::RadianceImage light = panorama_of(128, gradient);
    scene::Scene scene = nothing_near();
    scene.instances[0].transform = glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, -1e6f});
    Settings settings = small_settings(32, 1.0f, 16);
    settings.height = 16;
    settings.background.kind = view::Background::Kind::environment;
    settings.panorama_from = glm::vec3(3.0f, 4.0f, 5.0f);
    const Result result = trace(scene, &light, settings);
    const image::RadianceImage expected = panorama_of(32, gradient);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x) {
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(result.radiance.pixel(x, y)[c], expected.pixel(x, y)[c], 0.02) << x << ' ' << y;
            EXPECT_EQ(result.radiance.pixel(x, y)[3], 0.0f);
        }
}

// A small square in one direction after another is met by the pixel that looks there, and no other.
TEST(ReferencePicture, APanoramaSeesThingsWhereTheyAre)
{
    const glm::vec3 from(1.0f, -2.0f, 3.0f);
    for (int y = 1; y < 16; y += 5)
        for (int x = 1; x < 32; x += 10) {
            const double phi = ((x + 0.5) / 32.0 - 0.5) * 2.0 * pi, theta = (y + 0.5) / 16.0 * pi;
            const glm::vec3 there = from + 10.0f * glm::vec3(std::sin(theta) * std::cos(phi), std::cos(theta),
                                                             std::sin(theta) * std::sin(phi));
            scene::Scene scene = scene_of(scene::make_sphere(0.25f, 16, 8), unlit({1.0f, 1.0f, 1.0f}));
            scene.instances[0].transform = glm::translate(glm::mat4(1.0f), there);
            Settings settings = small_settings(32, 1.0f, 512);
            settings.height = 16;
            settings.panorama_from = from;
            const Result result = trace(scene, nullptr, settings);
            for (int j = 0; j < 16; ++j)
                for (int i = 0; i < 32; ++i)
                    EXPECT_EQ(result.radiance.pixel(i, j)[3] > 0.0f, i == x && j == y) << i << ' ' << j;
        }
}

Result only_background(const view::Background& background, float rotation = 0.0f)
{
    const image::RadianceImage light = panorama_of(512, gradient);
    Settings settings = small_settings(16, 1.0f, 256);
    settings.camera.vertical_fov = 0.01f; // towards -Z, and hardly anywhere else
    settings.camera.position = {0.0f, 0.0f, -2000.0f};
    settings.background = background;
    settings.environment_rotation = rotation;
    return trace(nothing_near(), &light, settings);
}

TEST(ReferencePicture, Backgrounds)
{
    using Kind = view::Background::Kind;
    expect_light(only_background({Kind::none, {}, 0.0f}), glm::dvec3(0.0));
    expect_light(only_background({Kind::color, {0.25f, 0.5f, 3.0f}, 0.0f}), {0.25, 0.5, 3.0});
    expect_light(only_background({Kind::environment, {}, 0.0f}), gradient({0.0, 0.0, -1.0}), 1e-3);
    // Turned a quarter counter-clockwise seen from above, +X comes to -Z.
    expect_light(only_background({Kind::environment, {}, 0.0f}, static_cast<float>(0.5 * pi)),
                 gradient({1.0, 0.0, 0.0}), 1e-3);
    EXPECT_EQ(only_background({Kind::color, {1.0f, 1.0f, 1.0f}, 0.0f}).radiance.pixel(3, 3)[3], 0.0f);
}

// Directions are off by a normally distributed angle along each axis: of light 1 + d.z the mean cosine is left.
TEST(ReferencePicture, ABlurredBackgroundIsAMean)
{
    for (const double roughness : {0.1, 0.4, 0.7}) {
        const double variance = std::pow(roughness, 4.0);
        const double cosine = test::integrate(
            [&](double angle) {
                return angle / variance * std::exp(-0.5 * angle * angle / variance) * std::cos(angle);
            },
            0.0, 10.0 * roughness * roughness);
        const Result result =
            only_background({view::Background::Kind::blurred, {}, static_cast<float>(roughness)});
        expect_light(result, {1.0, 1.0, 1.0 - 0.9 * cosine}, 1e-3);
    }
}

} // namespace
} // namespace lambent::reference
