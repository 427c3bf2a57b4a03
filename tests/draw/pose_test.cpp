// A renderer that goes on to another moment draws what a new one of that moment draws, bit by bit.
#include "tests/draw/pose_scenes.h"
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

namespace lambent::draw::testing {
namespace {

TEST(Pose, IsDrawnAsByARendererOfItsOwn)
{
    const environment::Environment white = white_environment();
    const scene::Scene first = pose_scene(0.0f), second = pose_scene(1.0f);
    scene::Scene without_images = second;
    without_images.images.clear();
    const Settings settings = pose_settings();
    const std::unique_ptr<Renderer> renderer = make_cpu_renderer(first);
    const Frame before = renderer->draw(&white, settings);
    EXPECT_EQ(before.radiance.values, draw(first, &white, settings).radiance.values);
    renderer->pose(without_images);
    const Frame after = renderer->draw(&white, settings);
    EXPECT_EQ(after.radiance.values, draw(second, &white, settings).radiance.values);
    EXPECT_NE(after.radiance.values, before.radiance.values);
    // Textures made anew, for another transfer, are the first scene's.
    Settings other = settings;
    other.texel_transfer = TexelTransfer::none;
    EXPECT_EQ(renderer->draw(&white, other).radiance.values, draw(second, &white, other).radiance.values);
    renderer->pose(first);
    EXPECT_EQ(renderer->draw(&white, settings).radiance.values, before.radiance.values);
}

TEST(Pose, MayComeBeforeTheFirstPicture)
{
    const scene::Scene first = pose_scene(0.0f), second = pose_scene(1.0f);
    const std::unique_ptr<Renderer> renderer = make_cpu_renderer(first);
    renderer->pose(second);
    EXPECT_EQ(renderer->draw(nullptr, pose_settings()).radiance.values,
              draw(second, nullptr, pose_settings()).radiance.values);
}

TEST(Pose, AnInstanceOfAnEmptyMeshIsOutOfSight)
{
    const scene::Scene all = pose_scene(0.0f);
    scene::Scene hidden = all;
    hidden.meshes.emplace_back();
    hidden.instances[0] = {static_cast<int>(hidden.meshes.size()) - 1, 0, glm::mat4(1.0f)};
    scene::Scene fewer = all;
    fewer.instances.erase(fewer.instances.begin());
    EXPECT_EQ(draw(hidden, nullptr, pose_settings()).radiance.values,
              draw(fewer, nullptr, pose_settings()).radiance.values);
}

} // namespace
} // namespace lambent::draw::testing
