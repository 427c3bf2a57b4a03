// A device that fails hands over to the processor, once, with a warning.
#include "base/error.h"
#include "draw/rescued_renderer.h"

#include <gtest/gtest.h>

#include <functional>

namespace lambent::draw {
namespace {

class Scripted : public Renderer {
public:
    Scripted(std::string name, std::function<void()> act) : name_(std::move(name)), act_(std::move(act)) {}

    Frame draw(const environment::Environment*, const Settings&, const std::function<void(float)>&) override
    {
        act_();
        return {};
    }

    void pose(const scene::Scene&) override {}

    Device device() const override { return {name_, ""}; }

private:
    std::string name_;
    std::function<void()> act_;
};

struct Stage {
    int device_draws = 0, other_draws = 0, others_made = 0;
    std::vector<std::string> warnings;
    std::function<void()> trouble = [] {};

    std::unique_ptr<Renderer> make()
    {
        return make_rescued_renderer(
            std::make_unique<Scripted>("device",
                                       [this] {
                                           ++device_draws;
                                           trouble();
                                       }),
            [this] {
                ++others_made;
                return std::make_unique<Scripted>("other", [this] { ++other_draws; });
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
