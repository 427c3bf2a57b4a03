// Whole pictures by both backends: built-in scenes, both models, lights, sampled and split-sum, transparency.
#include "draw/cpu/cpu_renderer.h"
#include "draw/vulkan/vulkan_renderer.h"
#include "environment/builtin.h"
#include "scene/builtin.h"
#include "tests/draw/test_scenes.h"
#include "tests/support/process.h"
#include "tests/vulkan/compute.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace lambent::draw {
namespace {

const environment::Environment& kitchen()
{
    static const environment::Environment made = environment::make_environment(
        environment::make_panorama(environment::make_builtin("kitchen", {.width = 512})));
    return made;
}

Settings settings_for(const scene::Scene& scene, Model model)
{
    Settings settings;
    settings.width = 160;
    settings.height = 90;
    settings.model = model;
    settings.camera = orbit_camera(scene::bounds(scene), {0.4f, 0.3f, 0.0f}, 0.7f, 16.0f / 9.0f);
    settings.background.kind = Background::Kind::environment;
    settings.environment_rotation = 0.5f;
    return settings;
}

// Whether light changes by more than a third from the pixel to one beside it.
bool is_edge(const image::RadianceImage& image, int x, int y)
{
    const float here = image.pixel(x, y)[1];
    for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        const int u = std::clamp(x + dx, 0, image.width - 1), v = std::clamp(y + dy, 0, image.height - 1);
        if (std::fabs(image.pixel(u, v)[1] - here) > 0.33f * std::max(here, 0.05f))
            return true;
    }
    return false;
}

// Away from edges, light cut at 1.
double relative_rmse(const image::RadianceImage& found, const image::RadianceImage& wanted)
{
    double squares = 0.0, sum = 0.0, count = 0.0;
    for (int y = 0; y < wanted.height; ++y)
        for (int x = 0; x < wanted.width; ++x) {
            if (is_edge(wanted, x, y))
                continue;
            for (int c = 0; c < 4; ++c) {
                const auto a = static_cast<double>(std::min(found.pixel(x, y)[c], 1.0f)),
                           b = static_cast<double>(std::min(wanted.pixel(x, y)[c], 1.0f));
                squares += (a - b) * (a - b);
                sum += b;
                count += 1.0;
            }
        }
    EXPECT_GT(count, 0.5 * static_cast<double>(wanted.values.size()));
    return std::sqrt(squares / count) / (sum / count);
}

class PictureParity : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (!test::Compute::open()) {
            ASSERT_FALSE(test::vulkan_required()) << "no Vulkan device";
            GTEST_SKIP() << "no Vulkan device";
        }
    }

    void expect_parity(const scene::Scene& scene, const Settings& settings, const std::string& name)
    {
        const test::LeaksOfDrivers allowed;
        const Frame wanted = make_cpu_renderer(scene)->draw(&kitchen(), settings);
        const std::unique_ptr<VulkanRenderer> renderer = make_vulkan_renderer(scene, {true, true, {}});
        const Frame found = renderer->draw(&kitchen(), settings);
        const double error = relative_rmse(found.radiance, wanted.radiance);
        std::printf("%s: %.2e\n", name.c_str(), error);
        EXPECT_LE(error, 2e-3) << name;
        EXPECT_EQ(renderer->complaints(), std::vector<std::string>()) << name;
        EXPECT_FALSE(found.passes.empty());
        ASSERT_EQ(found.layers.size(), wanted.layers.size());
        for (std::size_t i = 0; i < found.layers.size(); ++i)
            EXPECT_LE(relative_rmse(found.layers[i].image, wanted.layers[i].image), 4e-3)
                << found.layers[i].name;
    }
};

TEST_F(PictureParity, EveryBuiltInSceneByBothModels)
{
    for (const std::string_view name : scene::builtin_names())
        for (const Model model : {Model::ggx, Model::phong}) {
            const scene::Scene scene = scene::make_builtin(name);
            expect_parity(scene, settings_for(scene, model),
                          std::string(name) + (model == Model::ggx ? " ggx" : " phong"));
        }
}

TEST_F(PictureParity, SplitSumLayersAndLights)
{
    const scene::Scene scene = scene::make_builtin("report");
    Settings settings = settings_for(scene, Model::ggx);
    settings.samples = split_sum_samples;
    settings.layers = true;
    scene::Light lamp;
    lamp.position = {0.3f, 0.8f, 0.5f};
    lamp.intensity = {0.5f, 0.6f, 0.7f};
    settings.lights.push_back(lamp);
    expect_parity(scene, settings, "split sum");
    settings.model = Model::phong;
    settings.mip_level = MipLevel::report;
    settings.layers = false;
    expect_parity(scene, settings, "as the report");
}

TEST_F(PictureParity, WhatIsTransparentAndWhatIsUnlit)
{
    scene::Scene scene = scene::make_builtin("report");
    scene.materials[0].alpha_mode = scene::AlphaMode::blend;
    scene.materials[0].base_color.a = 0.4f;
    scene.materials[1].unlit = true;
    scene.materials[1].base_color = {0.2f, 0.9f, 0.3f, 1.0f};
    expect_parity(scene, settings_for(scene, Model::ggx), "transparent and unlit");
}

TEST_F(PictureParity, DarknessAndEmptyPicturesAreDrawn)
{
    const test::LeaksOfDrivers allowed;
    const scene::Scene scene = scene::make_builtin("report");
    const std::unique_ptr<VulkanRenderer> renderer = make_vulkan_renderer(scene, {true, true, {}});
    Settings settings = settings_for(scene, Model::ggx);
    const Frame lit = renderer->draw(nullptr, settings);
    const Frame wanted = make_cpu_renderer(scene)->draw(nullptr, settings);
    EXPECT_LE(relative_rmse(lit.radiance, wanted.radiance), 1e-3);
    settings.camera.back = -settings.camera.back; // away from everything
    settings.camera.right = -settings.camera.right;
    const Frame empty = renderer->draw(nullptr, settings);
    for (const float value : empty.radiance.values)
        ASSERT_EQ(value, 0.0f);
    EXPECT_EQ(renderer->complaints(), std::vector<std::string>());
}

TEST_F(PictureParity, CompiledShadersAreKept)
{
    const test::LeaksOfDrivers allowed;
    const lambent::testing::Folder folder;
    const scene::Scene scene = scene::make_builtin("plane");
    make_vulkan_renderer(scene, {true, false, folder.path("")})
        ->draw(&kitchen(), settings_for(scene, Model::ggx));
    EXPECT_TRUE(std::filesystem::exists(folder.path("shaders.bin")));
}

} // namespace
} // namespace lambent::draw
