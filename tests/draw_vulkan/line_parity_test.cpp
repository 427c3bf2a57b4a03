// Points, lines and sets of texture coordinates on a device, against the processor's pictures.
#include "draw/cpu/cpu_renderer.h"
#include "draw/line_renderer.h"
#include "draw/vulkan/vulkan_renderer.h"
#include "tests/draw/line_scenes.h"
#include "tests/draw/texcoord_scene.h"
#include "tests/vulkan/compute.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lambent::draw::testing {
namespace {

class LineParity : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (!test::Compute::open()) {
            ASSERT_FALSE(test::vulkan_required()) << "no Vulkan device";
            GTEST_SKIP() << "no Vulkan device";
        }
    }
};

Frame by_device(const scene::Scene& scene, const environment::Environment* environment,
                const Settings& settings)
{
    return with_lines(make_vulkan_renderer(scene, {true, true, {}}), scene)->draw(environment, settings);
}

Frame by_processor(const scene::Scene& scene, const environment::Environment* environment,
                   const Settings& settings)
{
    return with_lines(make_cpu_renderer(scene), scene)->draw(environment, settings);
}

// A star of lines at all angles, points, and lines with normals, from an odd camera.
scene::Scene many_lines()
{
    scene::Scene scene;
    scene::Mesh star;
    for (int i = 0; i < 24; ++i) {
        const float turn = 0.2617994f * static_cast<float>(i) + 0.1f;
        star.positions.emplace_back(0.2f * std::cos(turn), 0.2f * std::sin(turn), 0.0f);
        star.positions.emplace_back(1.6f * std::cos(turn), 1.6f * std::sin(turn),
                                    0.5f * std::sin(5.0f * turn));
        star.lines.emplace_back(2 * i, 2 * i + 1);
        star.colors.emplace_back(1.0f, 0.2f, 0.1f, 1.0f);
        star.colors.emplace_back(0.1f, 0.4f, 1.0f, 1.0f);
    }
    add(scene, star, line_material(glm::vec3(1.0f)));
    std::vector<glm::vec3> places;
    for (int i = 0; i < 40; ++i)
        places.emplace_back(0.08f * static_cast<float>(i) - 1.6f, 0.9f,
                            0.3f * std::sin(static_cast<float>(i)));
    add(scene, points(places), line_material({0.3f, 1.0f, 0.2f}));
    scene::Mesh lit = star;
    lit.colors.clear();
    lit.normals.assign(lit.positions.size(), glm::normalize(glm::vec3(0.3f, 1.0f, 0.5f)));
    scene::Material gray = line_material(glm::vec3(0.7f));
    gray.unlit = false;
    gray.metallic = 0.0f;
    add(scene, lit, gray, glm::translate(glm::mat4(1.0f), {0.1f, 0.05f, -0.6f}));
    scene.instances.push_back({2, -1, glm::scale(glm::mat4(1.0f), {-0.6f, 0.6f, 0.6f})});
    return scene;
}

double mean(const image::RadianceImage& picture, std::size_t channel)
{
    double sum = 0.0;
    for (std::size_t i = channel; i < picture.values.size(); i += 4)
        sum += static_cast<double>(picture.values[i]);
    return sum / static_cast<double>(picture.values.size() / 4);
}

// A device's raster counts in 256ths of a pixel: at a strip's side a look may fall on the other side. Over all they agree,
// and few pixels differ.
TEST_F(LineParity, LinesAreWhereTheProcessorHasThem)
{
    const environment::Environment sky =
        environment_of(64, [](glm::dvec3 d) { return glm::vec3(d.y > 0.0 ? 1.0f : 0.2f); });
    Settings settings = small_settings(
        200, 140,
        orbit_camera({{-1.7f, -1.7f, -1}, {1.7f, 1.7f, 1}}, {0.5f, 0.4f, 0.0f}, 0.8f, 200.0f / 140.0f));
    settings.samples = 16;
    const scene::Scene scene = many_lines();
    const Frame found = by_device(scene, &sky, settings), wanted = by_processor(scene, &sky, settings);
    EXPECT_GT(mean(wanted.radiance, 3), 0.05);
    for (std::size_t channel = 0; channel < 4; ++channel)
        EXPECT_NEAR(mean(found.radiance, channel), mean(wanted.radiance, channel),
                    0.01 * mean(wanted.radiance, channel))
            << channel;
    std::size_t different = 0, seen = 0;
    for (std::size_t i = 3; i < wanted.radiance.values.size(); i += 4) {
        seen += wanted.radiance.values[i] > 0.0f ? 1 : 0;
        different += std::fabs(wanted.radiance.values[i] - found.radiance.values[i]) > 0.3f ? 1 : 0;
    }
    EXPECT_LE(different, seen / 50);
}

TEST_F(LineParity, LinesOnTheBorderAreHalfSeen)
{
    scene::Mesh frame;
    frame.positions = {{-20, -20, 0}, {20, -20, 0}, {20, 20, 0}, {-20, 20, 0}};
    frame.lines = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    const Frame picture =
        by_device(scene_of(frame, line_material({1, 0, 0})), nullptr, pixel_settings(40, 40));
    for (int i = 1; i < 39; ++i)
        for (const glm::ivec2& at : {glm::ivec2(i, 0), {i, 39}, {0, i}, {39, i}})
            EXPECT_NEAR(pixel(picture, at.x, at.y).a, 0.5f, 0.01f) << at.x << " " << at.y;
}

TEST_F(LineParity, EachTextureReadsItsOwnSetOfCoordinates)
{
    const environment::Environment white = white_environment();
    Settings settings = small_settings(32, 32, front_camera(1.5f));
    settings.layers = true;
    const scene::Scene scene = texcoord_scene({9, 4, 0, 1, 2});
    const Frame found = by_device(scene, &white, settings), wanted = by_processor(scene, &white, settings);
    for (std::size_t channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(mean(found.radiance, channel), mean(wanted.radiance, channel), 2e-3);
    for (const char* layer : {"base_color", "roughness", "normal", "light_emitted", "light_ambient"})
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(layer_pixel(found, layer, 16, 16)[c], layer_pixel(wanted, layer, 16, 16)[c], 2e-3f)
                << layer;
}

} // namespace
} // namespace lambent::draw::testing
