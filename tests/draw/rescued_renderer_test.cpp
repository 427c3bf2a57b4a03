// A device that fails hands over to the processor, once, with a warning.
#include "base/error.h"
#include "draw/rescued_renderer.h"

#include <gtest/gtest.h>

#include <functional>

namespace lambent::draw {
namespace {

class ScriptedDrawing : public Drawing {
public:
    explicit ScriptedDrawing(const std::function<void()>& act) : act_(act) {}

    bool advance(const GoOn& go_on) override
    {
        act_();
        return !go_on || go_on(0.5f);
    }

    Frame take() override { return {}; }

private:
    const std::function<void()>& act_;
};

class Scripted : public Renderer {
public:
    using Poses = std::vector<const scene::Scene*>;

    Scripted(std::string name, std::function<void()> act, Poses& poses)
        : name_(std::move(name)), act_(std::move(act)), poses_(poses)
    {
    }

    std::unique_ptr<Drawing> start(const environment::Environment*, const Settings&) override
    {
        return std::make_unique<ScriptedDrawing>(act_);
    }

    void pose(const scene::Scene& scene) override { poses_.push_back(&scene); }

    Device device() const override { return {name_, ""}; }

private:
    std::string name_;
    std::function<void()> act_;
    Poses& poses_;
};

struct Stage {
    int device_draws = 0, other_draws = 0, others_made = 0;
    std::vector<std::string> warnings;
    Scripted::Poses device_poses, other_poses;
    std::function<void()> trouble = [] {};

    std::unique_ptr<Renderer> make()
    {
        return make_rescued_renderer(
            std::make_unique<Scripted>(
                "device",
                [this] {
                    ++device_draws;
                    trouble();
                },
                device_poses),
            [this] {
                ++others_made;
                return std::make_unique<Scripted>(
                    "other", [this] { ++other_draws; }, other_poses);
            },
            [this](const std::string& line) { warnings.push_back(line); });
    }
};

TEST(RescuedRenderer, DrawsOnTheDeviceWhileThatGoesWell)
{
    Stage stage;
    const std::unique_ptr<Renderer> renderer = stage.make();
    renderer->draw(nullptr, {});
    renderer->draw(nullptr, {});
    EXPECT_EQ(stage.device_draws, 2);
    EXPECT_EQ(stage.others_made, 0);
    EXPECT_EQ(renderer->device().backend, "device");
}

TEST(RescuedRenderer, ALostDeviceIsSaidOnceAndNotAskedAgain)
{
    Stage stage;
    const std::unique_ptr<Renderer> renderer = stage.make();
    renderer->draw(nullptr, {});
    stage.trouble = [] { throw Error(Failure::no_device, "the device was lost"); };
    renderer->draw(nullptr, {});
    renderer->draw(nullptr, {});
    EXPECT_EQ(stage.device_draws, 2);
    EXPECT_EQ(stage.other_draws, 2); // the picture that failed, and the next
    EXPECT_EQ(stage.others_made, 1);
    EXPECT_EQ(stage.warnings, std::vector<std::string>{"the device was lost"});
    EXPECT_EQ(renderer->device().backend, "other");
}

TEST(RescuedRenderer, TheOtherTakesThePoseOver)
{
    Stage stage;
    const scene::Scene first, second, third;
    const std::unique_ptr<Renderer> renderer = stage.make();
    renderer->pose(first);
    renderer->pose(second);
    stage.trouble = [] { throw Error(Failure::no_device, "the device was lost"); };
    renderer->draw(nullptr, {});
    EXPECT_EQ(stage.device_poses, (Scripted::Poses{&first, &second}));
    EXPECT_EQ(stage.other_poses, Scripted::Poses{&second});
    renderer->pose(third);
    EXPECT_EQ(stage.device_poses.size(), 2u);
    EXPECT_EQ(stage.other_poses, (Scripted::Poses{&second, &third}));
}

// One drawing meets the failure; another that was begun before must not go on on the device that is gone.
TEST(RescuedRenderer, PicturesThatWereBegunAreBegunAnew)
{
    Stage stage;
    const std::unique_ptr<Renderer> renderer = stage.make();
    const std::unique_ptr<Drawing> first = renderer->start(nullptr, {}),
                                   second = renderer->start(nullptr, {});
    const auto stop = [](float) { return false; };
    EXPECT_FALSE(first->advance(stop));
    EXPECT_FALSE(second->advance(stop));
    EXPECT_EQ(stage.device_draws, 2);
    stage.trouble = [] { throw Error(Failure::no_device, "the device was lost"); };
    EXPECT_TRUE(first->advance({}));
    EXPECT_TRUE(second->advance({}));
    EXPECT_EQ(stage.device_draws, 3);
    EXPECT_EQ(stage.other_draws, 2);
    EXPECT_EQ(stage.others_made, 1);
}

TEST(RescuedRenderer, WhatIsNotTheDevicesFaultIsPassedOn)
{
    struct Left {};
    Stage stage;
    const std::unique_ptr<Renderer> renderer = stage.make();
    stage.trouble = [] { throw Left{}; };
    EXPECT_THROW(renderer->draw(nullptr, {}), Left);
    stage.trouble = [] { throw Error(Failure::usage, "no such layer"); };
    EXPECT_THROW(renderer->draw(nullptr, {}), Error);
    EXPECT_EQ(stage.others_made, 0);
    EXPECT_TRUE(stage.warnings.empty());
}

} // namespace
} // namespace lambent::draw
