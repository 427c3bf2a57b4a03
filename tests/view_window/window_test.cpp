// `lambent view` on a screen that nobody sees, moved by xdotool.
#include "base/text.h"
#include "tests/view_window/desktop.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace lambent {
namespace {

using testing::Desktop;
using testing::Outcome;
using testing::Running;
using testing::Screenshot;

// The picture without panel and line.
constexpr Screenshot::Area picture = {0, 0, 900, 620};

std::string contents(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class ViewWindow : public ::testing::Test {
protected:
    void SetUp() override
    {
        std::string why;
        desktop_ = Desktop::open(why);
        if (!desktop_) {
            ASSERT_EQ(std::getenv("LAMBENT_REQUIRE_DISPLAY"), nullptr) << why;
            GTEST_SKIP() << why;
        }
    }

    // The window's folder is the desktop's, and so are its settings. Drivers keep some memory to the end of the program.
    void open(const std::string& scene)
    {
        const std::string& folder = desktop_->folder().path(".");
        program_ = std::make_unique<Running>(
            std::vector<std::string>{"env", text("--chdir=", folder), text("DISPLAY=", desktop_->display()),
                                     text("XDG_CONFIG_HOME=", desktop_->folder().path("config")),
                                     "LSAN_OPTIONS=detect_leaks=0", LAMBENT_PROGRAM, "view", scene},
            log());
        ASSERT_TRUE(desktop_->act({"search", "--sync", "--onlyvisible", "--name", "lambent"}))
            << contents(log());
        ASSERT_TRUE(desktop_->act({"search", "--name", "lambent", "windowfocus"}));
    }

    void drag(const char* button, const char* modifier)
    {
        if (modifier) {
            EXPECT_TRUE(desktop_->act({"keydown", modifier}));
        }
        EXPECT_TRUE(
            desktop_->act({"mousemove", "300", "300", "sleep", "0.1", "mousedown", button, "sleep", "0.1"}));
        for (const char* x : {"330", "360", "400"})
            EXPECT_TRUE(desktop_->act({"mousemove", x, "320", "sleep", "0.1"}));
        EXPECT_TRUE(desktop_->act({"mouseup", button}));
        if (modifier) {
            EXPECT_TRUE(desktop_->act({"keyup", modifier}));
        }
    }

    void press(const char* key) { EXPECT_TRUE(desktop_->act({"key", key})); }
    Screenshot look() const { return desktop_->look_at_rest(30.0); }
    std::string log() const { return desktop_->folder().path("view.log"); }

    std::unique_ptr<Desktop> desktop_;
    std::unique_ptr<Running> program_;
};

TEST_F(ViewWindow, HandsMoveWhatIsSeen)
{
    open("sphere");
    Screenshot before = look();
    ASSERT_EQ(before.width, 1280);
    EXPECT_GT(before.mean(picture), 20.0);
    const auto expect_change = [&](const char* what, double least) {
        Screenshot after = look();
        EXPECT_GT(after.difference(before, picture), least) << what;
        before = std::move(after);
    };
    drag("1", nullptr);
    expect_change("orbit", 3.0);
    drag("3", nullptr);
    expect_change("pan", 3.0);
    drag("1", "shift");
    expect_change("environment", 1.0);
    EXPECT_TRUE(desktop_->act({"mousemove", "400", "300", "click", "5", "sleep", "0.1", "click", "5"}));
    expect_change("dolly", 1.0);
    press("Right");
    expect_change("arrow", 1.0);
    press("F1");
    expect_change("help", 1.0);
    press("F1");
    press("ctrl+q");
    EXPECT_EQ(program_->wait(30.0), 0) << contents(log());
    EXPECT_EQ(contents(log()), "");
}

TEST_F(ViewWindow, ThePanelsSliderChangesTheExposure)
{
    open("sphere");
    const double before = look().mean(picture);
    // The first slider: exposure, from 0.01 to 100 by its logarithm. Wherever the letters' size puts it.
    double after = before;
    for (int y = 50; y < 90 && std::abs(after - before) < 10.0; y += 6) {
        EXPECT_TRUE(desktop_->act({"mousemove", "1070", text(y), "sleep", "0.1", "mousedown", "1", "sleep",
                                   "0.1", "mousemove", "1080", text(y), "sleep", "0.1", "mouseup", "1"}));
        EXPECT_TRUE(desktop_->act({"mousemove", "400", "300"}));
        after = look().mean(picture);
    }
    EXPECT_GT(after, before + 10.0);
    press("r");
    EXPECT_NEAR(look().mean(picture), before, 2.0);
    press("e");
    EXPECT_GT(look().mean(picture), before + 3.0);
}

TEST_F(ViewWindow, WhatIsSavedIsWhatTheCommandDraws)
{
    open("teapot");
    look();
    drag("1", nullptr);
    look();
    press("s");
    const std::string saved = desktop_->folder().path("picture.png");
    look();
    ASSERT_TRUE(std::filesystem::exists(saved)) << contents(log());
    press("s");
    look();
    EXPECT_TRUE(std::filesystem::exists(desktop_->folder().path("picture-2.png"))); // nothing is written over
    press("ctrl+q");
    EXPECT_EQ(program_->wait(30.0), 0);
    const nlohmann::json settings =
        nlohmann::json::parse(contents(desktop_->folder().path("config/lambent/view.json")));
    EXPECT_EQ(settings["version"], 1);
    EXPECT_EQ(settings["width"], 1280);
    // Half a turn over the window's height of 720: 100 pixels are 25 degrees, 20 down are 5.
    const std::string drawn = desktop_->folder().path("drawn.png");
    const Outcome render = testing::run_program(
        LAMBENT_PROGRAM, {"render", "teapot", "--size", "1280x720", "--camera", "5,25", "-o", drawn});
    ASSERT_EQ(render.code, 0) << render.error;
    EXPECT_EQ(contents(saved) == contents(drawn), true);
}

TEST_F(ViewWindow, ABrokenMemoryIsSaidAndForgotten)
{
    std::filesystem::create_directories(desktop_->folder().path("config/lambent"));
    std::ofstream(desktop_->folder().path("config/lambent/view.json")) << "{\"version\": 1, ";
    open("sphere");
    look();
    press("ctrl+q");
    EXPECT_EQ(program_->wait(30.0), 0);
    EXPECT_NE(contents(log()).find("warning"), std::string::npos);
    EXPECT_TRUE(nlohmann::json::accept(contents(desktop_->folder().path("config/lambent/view.json"))));
}

TEST(View, WithoutADisplayItSaysSo)
{
    const Outcome outcome =
        testing::run_program("env", {"-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", "LSAN_OPTIONS=detect_leaks=0",
                                     LAMBENT_PROGRAM, "view", "sphere"});
    EXPECT_EQ(outcome.code, 4) << outcome.error;
    EXPECT_EQ(outcome.error.rfind("lambent: error: no window can be opened", 0), 0u) << outcome.error;
}

TEST(View, WhatCannotBeOpenedIsSaidBeforeAWindowIs)
{
    const Outcome outcome = testing::run_program(LAMBENT_PROGRAM, {"view", "/nowhere/at-all.glb"});
    EXPECT_EQ(outcome.code, 3) << outcome.error;
    EXPECT_NE(outcome.error.find("at-all.glb"), std::string::npos);
}

} // namespace
} // namespace lambent
