// Whole pictures by both backends: built-in scenes, both models, lights, sampled and split-sum, transparency.
#include "draw/cpu/cpu_renderer.h"
#include "draw/vulkan/vulkan_renderer.h"
#include "environment/builtin/builtin.h"
#include "scene/builtin/builtin.h"
#include "tests/draw/parity_scene.h"
#include "tests/draw/pose_scenes.h"
#include "tests/draw/test_scenes.h"
#include "tests/support/process.h"
#include "tests/vulkan/compute.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <utility>

namespace lambent::draw {
namespace {

const environment::Environment& kitchen()
{
    static const environment::Environment made = environment::make_environment(
        environment::make_panorama(environment::make_builtin("kitchen", {.width = 512})));
    return made;
}

// With few looks at edges, which both backends group in the same way; see EdgesByTheUsualLooks.
Settings settings_for(const scene::Scene& scene, Model model)
{
    Settings settings;
    settings.width = 160;
    settings.height = 90;
    settings.edge_samples = 4;
    settings.model = model;
    settings.camera = orbit_camera(scene::bounds(scene), {0.4f, 0.3f, 0.0f}, 0.7f, 16.0f / 9.0f);
    settings.background.kind = Background::Kind::environment;
    settings.environment_rotation = 0.5f;
    return settings;
}

const image::RadianceImage& layer(const Frame& frame, const char* name)
{
    for (const Layer& layer : frame.layers)
        if (layer.name == name)
            return layer.image;
    throw std::invalid_argument(name);
}

// Pixels where surfaces end, or bend by more than 30 degrees towards a neighbour, or where light changes by more than a
// third. There a device's raster, which counts places in 256ths of a pixel, may see another surface than a ray does.
std::vector<bool> edges_of(const Frame& with_layers)
{
    const image::RadianceImage &light = with_layers.radiance, &normals = layer(with_layers, "normal");
    const auto normal = [&](int x, int y) { return glm::make_vec3(normals.pixel(x, y)); };
    std::vector<bool> edges;
    for (int y = 0; y < light.height; ++y)
        for (int x = 0; x < light.width; ++x) {
            const float here = light.pixel(x, y)[1], coverage = light.pixel(x, y)[3];
            bool edge = coverage > 1e-3f && glm::length(normal(x, y)) < 0.99f * coverage;
            for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
                const int u = std::clamp(x + dx, 0, light.width - 1),
                          v = std::clamp(y + dy, 0, light.height - 1);
                const float* const there = light.pixel(u, v);
                edge = edge || std::fabs(there[3] - coverage) > 1e-3f ||
                       std::fabs(there[1] - here) > 0.33f * std::max(here, 0.05f) ||
                       (coverage > 0.0f && glm::dot(normal(x, y), normal(u, v)) < 0.866f);
            }
            edges.push_back(edge);
        }
    return edges;
}

// Away from edges, light cut at 1.
double relative_rmse(const image::RadianceImage& found, const image::RadianceImage& wanted,
                     const std::vector<bool>& edges)
{
    double squares = 0.0, sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < wanted.values.size(); ++i) {
        if (edges[i / 4])
            continue;
        const auto a = static_cast<double>(std::min(found.values[i], 1.0f)),
                   b = static_cast<double>(std::min(wanted.values[i], 1.0f));
        squares += (a - b) * (a - b);
        sum += b;
        count += 1.0;
    }
    EXPECT_GT(count, 0.5 * static_cast<double>(wanted.values.size()));
    return sum > 0.0 ? std::sqrt(squares / count) / (sum / count) : std::sqrt(squares);
}

// What is shown without lighting: black where the frame has none.
image::RadianceImage unlit_of(const Frame& frame)
{
    image::RadianceImage image = frame.radiance;
    image.values = std::exchange(image.unlit, {});
    if (image.values.empty())
        image.values.resize(frame.radiance.values.size(), 0.0f);
    return image;
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

    // Both backends draw it with its layers; the device once more without. Layers may differ by more than their sum: of
    // two looks that are equally near to the middle of a surface either is lit.
    void expect_parity(const scene::Scene& scene, const Settings& settings, const std::string& name)
    {
        Settings layered = settings;
        layered.layers = true;
        const Frame wanted = make_cpu_renderer(scene)->draw(&kitchen(), layered);
        const std::vector<bool> edges = edges_of(wanted);
        const std::unique_ptr<VulkanRenderer> renderer = make_vulkan_renderer(scene, {true, true, {}});
        const Frame found = renderer->draw(&kitchen(), settings), apart = renderer->draw(&kitchen(), layered);
        const double error = relative_rmse(found.radiance, wanted.radiance, edges);
        std::printf("%s: %.2e\n", name.c_str(), error);
        EXPECT_LE(error, 2e-3) << name;
        EXPECT_LE(relative_rmse(found.radiance, apart.radiance, edges), 1e-6) << name;
        EXPECT_EQ(renderer->complaints(), std::vector<std::string>()) << name;
        EXPECT_FALSE(found.passes.empty());
        for (const Frame* frame : {&found, &apart})
            EXPECT_LE(relative_rmse(unlit_of(*frame), unlit_of(wanted), edges), 2e-3) << name << ", unlit";
        ASSERT_EQ(apart.layers.size(), wanted.layers.size());
        for (std::size_t i = 0; i < apart.layers.size(); ++i) {
            EXPECT_EQ(apart.layers[i].name, wanted.layers[i].name);
            EXPECT_LE(relative_rmse(apart.layers[i].image, wanted.layers[i].image, edges), 1e-2)
                << name << " " << apart.layers[i].name;
        }
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
    scene::Light lamp;
    lamp.position = {0.3f, 0.8f, 0.5f};
    lamp.intensity = {0.5f, 0.6f, 0.7f};
    settings.lights.push_back(lamp);
    expect_parity(scene, settings, "split sum");
    settings.model = Model::phong;
    settings.mip_level = MipLevel::report;
    expect_parity(scene, settings, "as the report");
}

TEST_F(PictureParity, EverySlotSamplerAndSideInOneScene)
{
    const scene::Scene scene = testing::parity_scene();
    for (const Model model : {Model::ggx, Model::phong}) {
        Settings settings = settings_for(scene, model);
        settings.width = 320;
        settings.height = 240;
        settings.samples = 16;
        scene::Light sun;
        sun.kind = scene::LightKind::directional;
        sun.direction = glm::normalize(glm::vec3(-0.4f, -0.7f, -0.6f));
        settings.lights.push_back(sun);
        expect_parity(scene, settings, model == Model::ggx ? "painted balls" : "painted balls, phong");
    }
}

// Textures of it or not.
TEST_F(PictureParity, OneRoughnessForAllSurfaces)
{
    scene::Scene scene = scene::make_builtin("painted");
    for (scene::Material& material : scene.materials)
        material.metallic_roughness_texture = material.base_color_texture;
    Settings settings = settings_for(scene, Model::ggx);
    settings.roughness_override = 0.35f;
    expect_parity(scene, settings, "one roughness");
    settings = settings_for(scene::make_builtin("grid"), Model::ggx);
    settings.roughness_override = 0.0f;
    settings.edge_samples = 1; // of mirrors every look at an edge counts by itself, and a raster may miss one
    expect_parity(scene::make_builtin("grid"), settings, "no roughness");
}

// Which looks of a smooth curved surface are lit as one hangs on the last bits of their normals, and with it where they are
// lit: backends then differ more at edges, but not on average.
TEST_F(PictureParity, EdgesByTheUsualLooks)
{
    for (const char* const name : {"grid", "report"}) {
        const scene::Scene scene = scene::make_builtin(name);
        Settings settings = settings_for(scene, Model::ggx);
        settings.edge_samples = Settings().edge_samples;
        ASSERT_GE(settings.edge_samples, 16);
        const Frame wanted = make_cpu_renderer(scene)->draw(&kitchen(), settings);
        const Frame found = make_vulkan_renderer(scene, {true, true, {}})->draw(&kitchen(), settings);
        const std::vector<bool> no_edges(wanted.radiance.values.size() / 4, false);
        EXPECT_LE(relative_rmse(found.radiance, wanted.radiance, no_edges), 1e-2) << name;
        const auto mean = [](const Frame& frame) {
            const std::vector<float>& values = frame.radiance.values;
            double sum = 0.0;
            for (const float value : values)
                sum += static_cast<double>(value);
            return sum / static_cast<double>(values.size());
        };
        EXPECT_NEAR(mean(found) / mean(wanted), 1.0, 1e-3) << name;
    }
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
    const scene::Scene scene = scene::make_builtin("report");
    const std::unique_ptr<VulkanRenderer> renderer = make_vulkan_renderer(scene, {true, true, {}});
    Settings settings = settings_for(scene, Model::ggx);
    const Frame lit = renderer->draw(nullptr, settings);
    const Frame wanted = make_cpu_renderer(scene)->draw(nullptr, settings);
    const std::vector<bool> no_edges(wanted.radiance.values.size() / 4, false);
    EXPECT_LE(relative_rmse(lit.radiance, wanted.radiance, no_edges), 1e-3);
    settings.camera.back = -settings.camera.back; // away from everything
    settings.camera.right = -settings.camera.right;
    const Frame empty = renderer->draw(nullptr, settings);
    for (const float value : empty.radiance.values)
        ASSERT_EQ(value, 0.0f);
    EXPECT_EQ(renderer->complaints(), std::vector<std::string>());
}

// Every way to be in front of or behind something: one-sided, two-sided, mirrored, cut out, glassy, many layers deep.
scene::Scene layers_of_panes()
{
    scene::Scene scene = scene::make_builtin("painted");
    scene::Mesh pane;
    pane.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    pane.normals.assign(4, {0, 0, 1});
    pane.triangles = {{0, 1, 2}, {0, 2, 3}};
    const auto first = static_cast<int>(scene.materials.size());
    for (const scene::AlphaMode mode :
         {scene::AlphaMode::blend, scene::AlphaMode::mask, scene::AlphaMode::opaque}) {
        scene::Material material;
        material.base_color = {0.8f, 0.3f, 0.2f, 0.45f};
        material.perceptual_roughness = 0.5f;
        material.metallic = 0.0f;
        material.alpha_mode = mode;
        material.double_sided = mode == scene::AlphaMode::blend;
        scene.materials.push_back(material);
    }
    scene.meshes.push_back(pane);
    for (int i = 0; i < 12; ++i) {
        scene::Instance instance;
        instance.mesh = static_cast<int>(scene.meshes.size()) - 1;
        instance.material = first + i % 3;
        const float side = i % 2 == 0 ? 0.4f : -0.4f; // a mirrored pane shows its front to the other side
        instance.transform = glm::mat4(side, 0, 0, 0, 0, 0.5f, 0, 0, 0.05f, 0, 0.5f, 0, 0, 0, 0, 1);
        instance.transform[3] = {0.2f * static_cast<float>(i % 4) - 0.3f, 0.02f * static_cast<float>(i),
                                 0.3f + 0.1f * static_cast<float>(i), 1.0f};
        scene.instances.push_back(instance);
    }
    return scene;
}

TEST_F(PictureParity, PanesOfEveryKindOneBehindTheOther)
{
    const scene::Scene scene = layers_of_panes();
    expect_parity(scene, settings_for(scene, Model::ggx), "panes");
    Settings settings = settings_for(scene, Model::phong);
    settings.edge_samples = 1;
    expect_parity(scene, settings, "panes, one look");
}

TEST_F(PictureParity, BackgroundsAndProjections)
{
    const scene::Scene scene = scene::make_builtin("report");
    Settings settings = settings_for(scene, Model::ggx);
    settings.background = {Background::Kind::blurred, {}, 0.4f};
    expect_parity(scene, settings, "blurred");
    settings.background = {Background::Kind::color, {0.3f, 0.6f, 0.1f}, 0.0f};
    settings.camera.vertical_fov = 0.0f;
    settings.camera.vertical_size = 1.2f * (scene::bounds(scene).high.y - scene::bounds(scene).low.y);
    expect_parity(scene, settings, "orthographic");
    settings = settings_for(scene, Model::ggx);
    settings.background.kind = Background::Kind::none;
    settings.samples = 300; // edges are then looked at 16 times
    settings.edge_samples = 7;
    expect_parity(scene, settings, "many samples");
}

// What is nearer or further away is cut off in the middle of things.
TEST_F(PictureParity, CamerasWithPlanesAndAnAspect)
{
    const scene::Scene scene = scene::make_builtin("report");
    Settings settings = settings_for(scene, Model::ggx);
    const float distance = glm::length(settings.camera.position);
    settings.camera.aspect = 3.0f;
    settings.camera.near = 0.95f * distance;
    settings.camera.far = 1.1f * distance;
    expect_parity(scene, settings, "planes");
    settings.camera.vertical_fov = 0.0f;
    settings.camera.vertical_size = 1.2f * (scene::bounds(scene).high.y - scene::bounds(scene).low.y);
    expect_parity(scene, settings, "planes, orthographic");
}

TEST_F(PictureParity, AThousandLights)
{
    const scene::Scene scene = scene::make_builtin("report");
    Settings settings = settings_for(scene, Model::ggx);
    settings.background.kind = Background::Kind::none;
    const scene::Bounds box = scene::bounds(scene);
    const glm::vec3 size = box.high - box.low;
    for (int i = 0; i < 1000; ++i) {
        scene::Light light;
        const auto fraction = [&](int step) { return static_cast<float>(i * step % 1000) / 999.0f; };
        light.position = box.low + glm::vec3(fraction(7), 0.2f + fraction(13), fraction(31)) * size;
        light.range = 0.1f * glm::length(size);
        light.intensity = 0.002f * glm::vec3(fraction(3), 1.0f, fraction(9));
        settings.lights.push_back(light);
    }
    expect_parity(scene, settings, "a thousand lights");
}

// Wider than a tile.
TEST_F(PictureParity, TilesMeetWithoutASeam)
{
    const scene::Scene scene = scene::make_builtin("grid");
    Settings settings = settings_for(scene, Model::ggx);
    settings.width = 4500;
    settings.height = 24;
    settings.samples = 4;
    settings.camera = orbit_camera(scene::bounds(scene), {0.4f, 0.3f, 0.2f}, 0.05f, 4500.0f / 24.0f);
    expect_parity(scene, settings, "wide");
}

// Triangles so small that a pixel shows a dozen: more surfaces than a tile has room for, which is drawn in parts.
TEST_F(PictureParity, MoreSurfacesThanRoom)
{
    scene::Scene scene = scene::make_builtin("plane");
    scene::Mesh& mesh = scene.meshes[0];
    mesh = {};
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(-1.0f, 1.0f), size(-0.015f, 0.015f);
    for (std::uint32_t i = 0; i < 90000; ++i) {
        const glm::vec3 middle(place(random), place(random), 0.02f * place(random));
        for (int corner = 0; corner < 3; ++corner) {
            mesh.positions.push_back(middle + glm::vec3(size(random), size(random), size(random)));
            mesh.normals.push_back({0, 0, 1});
        }
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    scene.instances.resize(1);
    scene.instances[0].transform = glm::mat4(1.0f);
    scene.materials[0].double_sided = true;
    Settings settings = settings_for(scene, Model::ggx);
    settings.camera = orbit_camera(scene::bounds(scene), {0.0f, 0.0f, 2.0f}, 0.7f, 16.0f / 9.0f);
    settings.samples = 4;
    settings.edge_samples = 24;
    const std::unique_ptr<VulkanRenderer> renderer = make_vulkan_renderer(scene, {true, true, {}});
    const Frame found = renderer->draw(&kitchen(), settings);
    const Frame wanted = make_cpu_renderer(scene)->draw(&kitchen(), settings);
    double sum_found = 0.0, sum_wanted = 0.0, apart = 0.0;
    for (std::size_t i = 0; i < found.radiance.values.size(); ++i) {
        const auto a = static_cast<double>(found.radiance.values[i]),
                   b = static_cast<double>(wanted.radiance.values[i]);
        sum_found += a, sum_wanted += b, apart += std::fabs(a - b);
    }
    EXPECT_NEAR(sum_found, sum_wanted, 2e-3 * sum_wanted);
    EXPECT_LE(apart, 0.02 * sum_wanted);
    EXPECT_EQ(renderer->complaints(), std::vector<std::string>());
}

// Devices keep the environment: the next picture may be under another, though at the same address, and look at it
// otherwise.
TEST_F(PictureParity, EnvironmentsFollowEachOther)
{
    const scene::Scene scene = testing::pose_scene(0.0f);
    const std::unique_ptr<VulkanRenderer> renderer = make_vulkan_renderer(scene, {true, true, {}});
    std::optional<environment::Environment> light;
    const auto expect_parity = [&](const environment::Environment* environment, const Settings& asked) {
        Settings settings = asked;
        settings.layers = true;
        const Frame wanted = make_cpu_renderer(scene)->draw(environment, settings);
        const Frame found = renderer->draw(environment, asked);
        EXPECT_LE(relative_rmse(found.radiance, wanted.radiance, edges_of(wanted)), 2e-3);
    };
    Settings settings = settings_for(scene, Model::ggx);
    for (const double red : {1.0, 3.0}) {
        light.reset();
        light = testing::environment_of(64, [&](glm::dvec3 d) { return glm::dvec3(red, 1.0 + d.y, 1.0); });
        expect_parity(&*light, settings);
    }
    expect_parity(nullptr, settings);
    settings.background.kind = Background::Kind::none;
    expect_parity(&kitchen(), settings);
    settings.mip_level = MipLevel::report;
    settings.background.kind = Background::Kind::environment;
    expect_parity(&kitchen(), settings);
    settings.mip_level = MipLevel::matched;
    expect_parity(&kitchen(), settings);
    EXPECT_EQ(renderer->complaints(), std::vector<std::string>());
}

// The largest difference of two pictures by the same device, over the largest value. Fragments come in the order in which
// its threads find them, by which sums are rounded otherwise in their last bits.
double apart(const image::RadianceImage& found, const image::RadianceImage& wanted)
{
    EXPECT_EQ(found.values.size(), wanted.values.size());
    double largest = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < wanted.values.size(); ++i) {
        const auto a = static_cast<double>(found.values[i]), b = static_cast<double>(wanted.values[i]);
        EXPECT_TRUE(std::isfinite(a));
        largest = std::max(largest, std::fabs(b));
        difference = std::max(difference, std::fabs(a - b));
    }
    return largest > 0.0 ? difference / largest : difference;
}

constexpr double same_device_bound = 1e-6;

// What pictures of other sizes, looks, layers and models are drawn with is kept and shared.
TEST_F(PictureParity, PicturesTakeTurns)
{
    const scene::Scene scene = testing::pose_scene(0.0f);
    std::vector<Settings> all(4, settings_for(scene, Model::ggx));
    all[1].width = 20, all[1].height = 90, all[1].edge_samples = 1;
    all[2].width = 130, all[2].height = 10, all[2].layers = true;
    all[3].model = Model::phong, all[3].width = 100, all[3].height = 100;
    std::vector<Frame> alone;
    alone.reserve(all.size());
    for (const Settings& settings : all)
        alone.push_back(make_vulkan_renderer(scene, {true, true, {}})->draw(&kitchen(), settings));
    const std::unique_ptr<VulkanRenderer> renderer = make_vulkan_renderer(scene, {true, true, {}});
    for (const std::size_t i : {0, 1, 0, 2, 3, 1, 2, 0}) {
        SCOPED_TRACE(i);
        const Frame found = renderer->draw(&kitchen(), all[i]);
        EXPECT_LE(apart(found.radiance, alone[i].radiance), same_device_bound);
        ASSERT_EQ(found.layers.size(), alone[i].layers.size());
        for (std::size_t layer = 0; layer < found.layers.size(); ++layer)
            EXPECT_LE(apart(found.layers[layer].image, alone[i].layers[layer].image), same_device_bound)
                << found.layers[layer].name;
    }
    EXPECT_EQ(renderer->complaints(), std::vector<std::string>());
}

// Wider than a tile is: drawn bit by bit, with another picture and another pose between, it is the same.
TEST_F(PictureParity, InPiecesItIsTheSame)
{
    const scene::Scene scene = testing::pose_scene(0.0f), moved = testing::pose_scene(1.0f);
    Settings settings = settings_for(scene, Model::ggx);
    settings.width = 4200;
    settings.height = 4;
    const std::unique_ptr<VulkanRenderer> renderer = make_vulkan_renderer(scene, {true, true, {}});
    const Frame wanted = renderer->draw(&kitchen(), settings);
    const std::unique_ptr<Drawing> drawing = renderer->start(&kitchen(), settings);
    EXPECT_FALSE(drawing->advance([](float) { return false; }));
    renderer->pose(moved);
    renderer->draw(nullptr, settings_for(scene, Model::ggx));
    renderer->pose(scene);
    EXPECT_TRUE(drawing->advance({}));
    const Frame found = drawing->take();
    EXPECT_LE(apart(found.radiance, wanted.radiance), same_device_bound);
    ASSERT_EQ(found.passes.size(), wanted.passes.size());
    for (std::size_t i = 0; i < found.passes.size(); ++i)
        EXPECT_EQ(found.passes[i].first, wanted.passes[i].first);
    EXPECT_EQ(renderer->complaints(), std::vector<std::string>());
}

// Another moment is drawn as by a renderer of its own, with the textures of the first.
TEST_F(PictureParity, APoseIsAsAScene)
{
    const scene::Scene first = testing::pose_scene(0.0f), second = testing::pose_scene(1.0f);
    scene::Scene without_images = second;
    without_images.images.clear();
    Settings settings = settings_for(second, Model::ggx);
    settings.layers = true;
    const std::unique_ptr<VulkanRenderer> renderer = make_vulkan_renderer(first, {true, true, {}});
    const Frame before = renderer->draw(&kitchen(), settings);
    renderer->pose(without_images);
    const Frame wanted = make_cpu_renderer(second)->draw(&kitchen(), settings);
    const std::vector<bool> edges = edges_of(wanted);
    EXPECT_LE(relative_rmse(renderer->draw(&kitchen(), settings).radiance, wanted.radiance, edges), 2e-3);
    EXPECT_GE(relative_rmse(before.radiance, wanted.radiance, edges), 0.05);
    settings.texel_transfer = TexelTransfer::none;
    const Frame linear = make_cpu_renderer(second)->draw(&kitchen(), settings);
    EXPECT_LE(relative_rmse(renderer->draw(&kitchen(), settings).radiance, linear.radiance, edges), 2e-3);
    EXPECT_EQ(renderer->complaints(), std::vector<std::string>());
}

TEST_F(PictureParity, CompiledShadersAreKept)
{
    const lambent::testing::Folder folder;
    const scene::Scene scene = scene::make_builtin("plane");
    make_vulkan_renderer(scene, {true, false, folder.path("")})
        ->draw(&kitchen(), settings_for(scene, Model::ggx));
    EXPECT_TRUE(std::filesystem::exists(folder.path("shaders.bin")));
}

} // namespace
} // namespace lambent::draw
