// What is seen where: cameras, sides, transforms, transparency, edges.
#include "trace/visibility.h"
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lambent::draw {
namespace {

using trace::Hit, trace::Rays, trace::Visibility;

using testing::add;
using testing::facing_square;
using testing::glowing;
using testing::pixel;

Settings view(int size, float extent = 2.0f)
{
    return testing::small_settings(size, size, testing::front_camera(extent));
}

TEST(Visibility, OutsideIsTheFrontAlsoWhenInstancedOrMirrored)
{
    for (float mirror : {1.0f, -1.0f})
        for (int copies : {1, 2}) { // two copies make the mesh an instance of a shared one
            scene::Scene scene;
            scene.materials.emplace_back();
            scene.meshes.push_back(scene::make_sphere(0.5f, 16, 8));
            for (int i = 0; i < copies; ++i)
                scene.instances.push_back(
                    {0, -1,
                     glm::scale(
                         glm::translate(glm::mat4(1.0f), glm::vec3(3.0f * static_cast<float>(i), 0, 0)),
                         glm::vec3(mirror, 1.0f, 2.0f))});
            const Visibility visibility(scene);
            Rays rays;
            rays.resize(1);
            rays.origin[0] = {0.1f}, rays.origin[1] = {0.05f}, rays.origin[2] = {5.0f};
            rays.direction[0] = {0.0f}, rays.direction[1] = {0.0f}, rays.direction[2] = {-1.0f};
            rays.near = {0.0f};
            Hit hit;
            visibility.trace(rays, &hit);
            ASSERT_TRUE(hit.found());
            EXPECT_EQ(hit.instance, 0u);
            EXPECT_TRUE(hit.front);
            EXPECT_GT(hit.normal.z, 0.5f);
            EXPECT_NEAR(hit.distance, 4.0f, 0.1f);
            rays.near = {4.5f}; // from inside
            visibility.trace(rays, &hit);
            ASSERT_TRUE(hit.found());
            EXPECT_FALSE(hit.front);
            EXPECT_LT(hit.normal.z, -0.5f);
        }
}

// What is without lighting is told apart from what is lit, where both share a pixel, too.
TEST(Visibility, SharesWithoutLightingAreKnown)
{
    scene::Scene scene;
    add(scene, facing_square(5.0f, 0.0f), glowing(glm::vec3(3.0f)));
    EXPECT_TRUE(testing::draw(scene, nullptr, view(8)).radiance.unlit.empty());
    scene::Material sign;
    sign.unlit = true;
    sign.base_color = {0.5f, 0.25f, 1.0f, 0.5f};
    sign.alpha_mode = scene::AlphaMode::blend;
    add(scene, facing_square(0.3f, 1.0f), sign); // its edges cross pixels
    Settings settings = view(8);
    settings.edge_samples = 16;
    const Frame frame = testing::draw(scene, nullptr, settings);
    ASSERT_EQ(frame.radiance.unlit.size(), frame.radiance.values.size());
    double share = 0.0;
    for (std::size_t i = 0; i < frame.radiance.unlit.size(); i += 4) {
        const float* const own = &frame.radiance.unlit[i];
        const float* const all = &frame.radiance.values[i];
        share += static_cast<double>(own[3]) / 64.0;
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(own[c], own[3] * sign.base_color[static_cast<int>(c)], 1e-6f);
            EXPECT_NEAR(all[c] - own[c], 3.0f * (1.0f - own[3]), 1e-5f);
        }
    }
    EXPECT_NEAR(share, 0.5 * 0.09, 0.01); // half of 0.6 by 0.6 metres of 4
}

TEST(Visibility, NearerHidesFarther)
{
    scene::Scene scene;
    add(scene, facing_square(1.0f, 0.0f), glowing({1, 0, 0}));
    add(scene, facing_square(0.5f, 1.0f), glowing({0, 1, 0}));
    const Frame frame = testing::draw(scene, nullptr, view(8));
    EXPECT_EQ(pixel(frame, 4, 4).g, 1.0f);
    EXPECT_EQ(pixel(frame, 4, 4).r, 0.0f);
    EXPECT_EQ(pixel(frame, 0, 0).r, 1.0f);
}

TEST(Visibility, BacksAreLookedThroughUnlessDoubleSided)
{
    const glm::mat4 turned = glm::rotate(glm::mat4(1.0f), 3.14159265f, glm::vec3(0, 1, 0));
    for (bool double_sided : {false, true}) {
        scene::Scene scene;
        scene::Material front = glowing({0, 1, 0});
        front.double_sided = double_sided;
        add(scene, facing_square(1.0f, -1.0f), front, turned); // at z = 1, facing away
        add(scene, facing_square(1.0f, 0.0f), glowing({1, 0, 0}));
        const glm::vec4 seen = pixel(testing::draw(scene, nullptr, view(8)), 3, 4);
        EXPECT_EQ(seen.g, double_sided ? 1.0f : 0.0f);
        EXPECT_EQ(seen.r, double_sided ? 0.0f : 1.0f);
    }
}

TEST(Visibility, UpIsUpAndRightIsRight)
{
    scene::Scene scene;
    add(scene, facing_square(0.2f, 0.0f), glowing({1, 0, 0}),
        glm::translate(glm::mat4(1.0f), glm::vec3(0.5f, 0, 0)));
    add(scene, facing_square(0.2f, 0.0f), glowing({0, 1, 0}),
        glm::translate(glm::mat4(1.0f), glm::vec3(0, 0.5f, 0)));
    const Frame frame = testing::draw(scene, nullptr, view(16));
    EXPECT_EQ(pixel(frame, 12, 8).r, 1.0f);
    EXPECT_EQ(pixel(frame, 8, 3).g, 1.0f);
}

TEST(Visibility, MasksCutAndBlendsMix)
{
    scene::Scene scene;
    scene::Material glass = glowing({0, 1, 0});
    glass.alpha_mode = scene::AlphaMode::blend;
    glass.base_color.a = 0.25f;
    scene::Material hole = glowing({5, 5, 5});
    hole.alpha_mode = scene::AlphaMode::mask;
    hole.base_color.a = 0.4f;
    add(scene, facing_square(1.0f, 0.0f), glowing({1, 0, 0}));
    add(scene, facing_square(1.0f, 1.0f), glass);
    add(scene, facing_square(1.0f, 2.0f), glass);
    add(scene, facing_square(1.0f, 3.0f), hole);
    const glm::vec4 seen = pixel(testing::draw(scene, nullptr, view(4)), 1, 2);
    EXPECT_NEAR(seen.g, 0.25f + 0.75f * 0.25f, 1e-6f);
    EXPECT_NEAR(seen.r, 0.75f * 0.75f, 1e-6f);
    EXPECT_NEAR(seen.a, 1.0f, 1e-6f);
}

// A hundred panes, then more than are drawn: what is behind the last one drawn is the background.
TEST(Visibility, ManyLayersDoNotSwallowTheBackground)
{
    scene::Material glass = glowing({0, 1, 0});
    glass.alpha_mode = scene::AlphaMode::blend;
    Settings settings = view(4);
    settings.background.kind = Background::Kind::color;
    settings.background.color = {0.0f, 0.0f, 2.0f};
    for (int layers : {100, 400}) {
        scene::Scene scene;
        glass.base_color.a = layers == 100 ? 0.02f : 0.0f;
        for (int i = 0; i < layers; ++i)
            add(scene, facing_square(1.0f, 0.01f * static_cast<float>(i)), glass);
        const glm::vec4 seen = pixel(testing::draw(scene, nullptr, settings), 1, 2);
        const float left = std::pow(1.0f - glass.base_color.a, static_cast<float>(layers));
        EXPECT_NEAR(seen.g, 1.0f - left, 1e-3f) << layers;
        EXPECT_NEAR(seen.b, 2.0f * left, 1e-3f) << layers;
    }
}

// Sizes whose squares and fourth powers no float holds: the same picture, or nothing where Embree's arithmetic ends.
TEST(Visibility, SizeDoesNotMatter)
{
    const environment::Environment white = testing::white_environment();
    for (float size : {1e-9f, 1e-5f, 1.0f, 1e5f, 1e9f, 1e11f, 1e15f, 1e18f}) {
        scene::Scene scene;
        scene::Material material;
        material.double_sided = true;
        add(scene, facing_square(size, 0.0f), material);
        scene::Bounds bounds;
        bounds.low = {-size, -size, 0.0f};
        bounds.high = {size, size, 0.0f};
        const Camera camera = orbit_camera(bounds, {0.6f, 0.3f, 0.0f}, 0.8f, 1.0f);
        const Frame frame = testing::draw(scene, &white, testing::small_settings(16, 16, camera));
        for (const float value : frame.radiance.values)
            ASSERT_TRUE(std::isfinite(value)) << size;
        if (size >= 1e-9f && size <= 1e11f) {
            EXPECT_NEAR(pixel(frame, 8, 8).a, 1.0f, 1e-6f) << size;
            EXPECT_NEAR(pixel(frame, 8, 8).g, 1.0f, 0.01f) << size;
        }
    }
}

TEST(Visibility, CamerasOutsideEmbreesRangeSeeNothing)
{
    scene::Scene scene;
    add(scene, facing_square(1.0f, 0.0f), glowing({0, 1, 0}));
    for (const Camera& camera : {testing::front_camera(2.0f, 1e25f), testing::front_camera(1e30f, 10.0f),
                                 testing::front_camera(2.0f, std::numeric_limits<float>::infinity())}) {
        const Frame frame = testing::draw(scene, nullptr, testing::small_settings(8, 8, camera));
        EXPECT_EQ(pixel(frame, 1, 1).a, 0.0f);
    }
}

TEST(Visibility, BlendedAloneIsPartlyCovered)
{
    scene::Scene scene;
    scene::Material glass = glowing({0, 1, 0});
    glass.alpha_mode = scene::AlphaMode::blend;
    glass.base_color.a = 0.25f;
    add(scene, facing_square(1.0f, 0.0f), glass);
    Settings settings = view(4);
    settings.background.kind = Background::Kind::color;
    settings.background.color = {0.0f, 0.0f, 2.0f};
    const glm::vec4 seen = pixel(testing::draw(scene, nullptr, settings), 1, 2);
    EXPECT_NEAR(seen.a, 0.25f, 1e-6f);
    EXPECT_NEAR(seen.b, 0.75f * 2.0f, 1e-6f);
}

// Coverage summed over the picture is the square's area; with more samples per pixel it comes closer.
TEST(Visibility, EdgesAreCoveredByTheirShare)
{
    scene::Scene scene;
    add(scene, facing_square(0.5f, 0.0f), glowing({1, 1, 1}),
        glm::rotate(glm::mat4(1.0f), 0.3f, glm::vec3(0, 0, 1)));
    const double pixels = std::pow(101.0 / 2.0, 2); // per square metre
    double before = 1.0;
    for (int samples : {1, 4, 16, 64}) {
        Settings settings = view(101);
        settings.edge_samples = samples;
        const Frame frame = testing::draw(scene, nullptr, settings);
        double covered = 0.0, roughness = 0.0;
        for (std::size_t i = 0; i < frame.radiance.values.size(); i += 4) {
            covered += frame.radiance.values[i + 3];
            ASSERT_NEAR(frame.radiance.values[i], frame.radiance.values[i + 3], 1e-6f);
        }
        EXPECT_NEAR(covered / pixels, 1.0, 0.01);
        // The exact coverage of every pixel, by 32x32 points.
        for (int y = 0; y < 101; ++y)
            for (int x = 0; x < 101; ++x) {
                int inside = 0;
                for (int k = 0; k < 1024; ++k) {
                    const double px = ((x + (k % 32 + 0.5) / 32) / 101 - 0.5) * 2.0;
                    const double py = (0.5 - (y + (k / 32 + 0.5) / 32) / 101) * 2.0;
                    const double u = std::cos(0.3) * px + std::sin(0.3) * py;
                    const double v = std::cos(0.3) * py - std::sin(0.3) * px;
                    inside += std::fabs(u) < 0.5 && std::fabs(v) < 0.5;
                }
                roughness += std::pow(inside / 1024.0 - static_cast<double>(pixel(frame, x, y).a), 2);
            }
        roughness = std::sqrt(roughness / (101.0 * 101.0));
        EXPECT_LT(roughness, samples == 1 ? 0.1 : before * 0.7) << samples;
        before = roughness;
    }
}

} // namespace
} // namespace lambent::draw
