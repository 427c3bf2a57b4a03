// Where rays of sight go, and what is seen where nothing is.
#include "tests/equations/quadrature.h"
#include "tests/reference/traced.h"

#include <glm/ext/matrix_transform.hpp>

#include <limits>
#include <tuple>

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

// Squares 10, 12 and 14 metres ahead, of light 1, 2 and 3: the nearest of those between the camera's planes is seen.
TEST(ReferencePicture, CamerasSeeBetweenTheirPlanes)
{
    scene::Scene scene;
    for (const int i : {0, 1, 2})
        add(scene, facing_square(20.0f, -2.0f * static_cast<float>(i)),
            unlit(glm::vec3(1.0f + static_cast<float>(i))));
    const float infinite = std::numeric_limits<float>::infinity();
    for (const float fov : {0.0f, 1.5f})
        for (const auto& [near, far, seen] : {std::tuple(0.0f, infinite, 1.0f),
                                              {9.99f, 10.01f, 1.0f},
                                              {10.01f, infinite, 2.0f},
                                              {12.01f, 20.0f, 3.0f},
                                              {0.0f, 9.99f, 0.0f},
                                              {10.01f, 11.99f, 0.0f}}) {
            Settings settings = small_settings(8, 4.0f, 4);
            settings.camera.vertical_fov = fov;
            settings.camera.near = near;
            settings.camera.far = far;
            const Result result = trace(scene, nullptr, settings);
            for (int x = 0; x < 8; ++x)
                EXPECT_EQ(result.radiance.pixel(x, 0)[0], seen)
                    << fov << ' ' << near << ' ' << far << ' ' << x;
        }
}

// A tenth of a millimetre, a metre, a hundred kilometres: by the same random numbers the same pictures.
TEST(ReferencePicture, ScenesOfAnySizeLookTheSame)
{
    const image::RadianceImage white = white_panorama();
    const auto traced = [&](float size) {
        scene::Scene scene;
        const glm::mat4 scaled = glm::scale(glm::mat4(1.0f), glm::vec3(size));
        add(scene, scene::make_sphere(1.0f, 48, 24), metallic(0.8f, 0.0f, 0.5f), scaled);
        add(scene, facing_square(2.0f, -1.0f), metallic(0.5f, 0.0f, 0.9f), scaled);
        scene::Material lamp = metallic(0.0f, 0.0f, 1.0f);
        lamp.emissive = glm::vec3(4.0f);
        lamp.double_sided = true;
        add(scene, facing_square(0.3f, 2.0f), lamp, scaled);
        Settings settings = small_settings(24, 4.0f * size, 32);
        settings.camera.position *= size;
        settings.bounces = 3;
        return trace(scene, &white, settings);
    };
    const Result metre = traced(1.0f);
    for (const float size : {0x1p-13f, 0x1p17f}) {
        const Result other = traced(size);
        for (int c = 0; c < 3; ++c) {
            const Average a = average(metre, whole(metre), c), b = average(other, whole(other), c);
            EXPECT_NEAR(a.mean, b.mean, 1e-3 * a.mean) << size;
        }
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
