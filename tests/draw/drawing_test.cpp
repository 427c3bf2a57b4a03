// Drawn bit by bit, with other pictures between the bits, a picture is the same as drawn at once.
#include "tests/draw/pose_scenes.h"
#include "tests/draw/test_scenes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace lambent::draw::testing {
namespace {

Settings several_tiles()
{
    Settings settings = pose_settings();
    settings.width = 150;
    settings.height = 100;
    settings.layers = true;
    return settings;
}

void expect_same(const Frame& found, const Frame& wanted)
{
    EXPECT_EQ(found.radiance.values, wanted.radiance.values);
    ASSERT_EQ(found.layers.size(), wanted.layers.size());
    for (std::size_t i = 0; i < found.layers.size(); ++i)
        EXPECT_EQ(found.layers[i].image.values, wanted.layers[i].image.values);
}

TEST(Drawing, InPiecesItIsTheSame)
{
    const environment::Environment white = white_environment();
    const scene::Scene scene = pose_scene(0.0f), moved = pose_scene(1.0f);
    const Settings settings = several_tiles();
    const Frame wanted = draw(scene, &white, settings);

    const std::unique_ptr<Renderer> renderer = make_cpu_renderer(scene);
    Settings others = pose_settings();
    others.texel_transfer = TexelTransfer::none;
    const Frame other = draw(moved, nullptr, others);
    int pieces = 1;
    float last = 0.0f;
    const std::unique_ptr<Drawing> drawing = renderer->start(&white, settings);
    const auto stop = [&](float done) {
        EXPECT_GT(done, last);
        last = done;
        return false;
    };
    for (; !drawing->advance(stop); ++pieces) {
        renderer->pose(moved);
        EXPECT_EQ(renderer->draw(nullptr, others).radiance.values, other.radiance.values);
        renderer->pose(scene);
    }
    EXPECT_GT(pieces, 3); // each thread may end its tile
    EXPECT_EQ(last, 1.0f);
    expect_same(drawing->take(), wanted);
}

// Also those that end while somebody is being told of another, and says no.
TEST(Drawing, EveryTileIsReportedOnce)
{
    const scene::Scene scene = pose_scene(0.0f);
    const std::unique_ptr<Renderer> renderer = make_cpu_renderer(scene);
    const std::unique_ptr<Drawing> drawing = renderer->start(nullptr, several_tiles());
    constexpr int tiles = 5 * 4; // of 32 pixels in 150x100
    std::vector<float> reports;
    const auto stop = [&](float done) {
        std::this_thread::sleep_for(std::chrono::milliseconds(3)); // others end theirs meanwhile
        reports.push_back(done);
        return false;
    };
    while (!drawing->advance(stop))
        EXPECT_LT(reports.size(), std::size_t{tiles});
    ASSERT_EQ(reports.size(), std::size_t{tiles});
    for (int i = 0; i < tiles; ++i)
        EXPECT_FLOAT_EQ(reports[static_cast<std::size_t>(i)], static_cast<float>(i + 1) / tiles);
}

TEST(Drawing, TwoAtOnceDoNotMix)
{
    const scene::Scene scene = pose_scene(0.0f);
    const std::unique_ptr<Renderer> renderer = make_cpu_renderer(scene);
    const Settings large = several_tiles(), small = pose_settings();
    const std::unique_ptr<Drawing> one = renderer->start(nullptr, large),
                                   two = renderer->start(nullptr, small);
    const auto stop = [](float) { return false; };
    for (bool first = false, second = false; !first || !second;) {
        first = first || one->advance(stop);
        second = second || two->advance(stop);
    }
    expect_same(one->take(), draw(scene, nullptr, large));
    expect_same(two->take(), draw(scene, nullptr, small));
}

TEST(Drawing, WhatIsThrownComesOut)
{
    const scene::Scene scene = pose_scene(0.0f);
    const std::unique_ptr<Renderer> renderer = make_cpu_renderer(scene);
    const std::unique_ptr<Drawing> drawing = renderer->start(nullptr, several_tiles());
    EXPECT_THROW(drawing->advance([](float) -> bool { throw std::runtime_error("left"); }),
                 std::runtime_error);
    expect_same(renderer->draw(nullptr, several_tiles()), draw(scene, nullptr, several_tiles()));
}

} // namespace
} // namespace lambent::draw::testing
