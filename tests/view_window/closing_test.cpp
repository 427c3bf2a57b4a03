// How the window begins and ends, and what it remembers.
#include "base/text.h"
#include "image/files/image_io.h"
#include "tests/view_window/window_fixture.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

namespace lambent::testing {
namespace {

using nlohmann::json;

json settings(const std::string& path)
{
    return json::parse(contents(path), nullptr, false);
}

// Slow enough to be closed meanwhile.
#ifdef __SANITIZE_ADDRESS__
const std::vector<std::string> slow = {"teapot", "--samples", "100"};
#else
const std::vector<std::string> slow = {"teapot", "--samples", "1024", "--aa", "16"};
#endif

TEST_F(ViewWindow, ClosingWaitsForWhatIsBeingSaved)
{
    open(slow);
    act({"sleep", "1", "key", "s", "sleep", "0.1", "key", "ctrl+q"});
    EXPECT_EQ(program_->wait(90.0), 0) << log();
    EXPECT_EQ(image::read_codes(path("picture.png")).width, 1280); // whole
}

TEST_F(ViewWindow, SignalsEndItAsClosingDoes)
{
    for (const int signal : {SIGTERM, SIGINT}) {
        open(slow);
        act({"sleep", "1", "key", "s", "sleep", "0.3"});
        program_->signal(signal);
        EXPECT_EQ(program_->wait(90.0), 0) << log();
        EXPECT_EQ(image::read_codes(path("picture.png")).width, 1280);
        EXPECT_EQ(settings(path("config/lambent/view.json"))["version"], 1);
        std::filesystem::remove(path("picture.png"));
        std::filesystem::remove(path("config/lambent/view.json"));
    }
    EXPECT_EQ(log(), "");
}

TEST_F(ViewWindow, WhatCannotBeSavedIsSaidBeforeTheEnd)
{
    for (const bool by_signal : {false, true}) {
        std::filesystem::create_directory(path("gone"));
        open({"sphere"}, "gone");
        look();
        std::filesystem::remove(path("gone"));
        act({"key", "s", "sleep", "0.01"});
        if (by_signal) {
            look_said();
            program_->signal(SIGTERM); // what failed before was said before
            EXPECT_EQ(program_->wait(30.0), 0) << log();
            continue;
        }
        press("ctrl+q");
        EXPECT_EQ(program_->wait(2.0), -1); // the window stays
        EXPECT_GT(look_said().redness(message_area), 0.005);
        expect_end();
    }
}

TEST_F(ViewWindow, ItsPlaceIsRemembered)
{
    open({"sphere"});
    look();
    act({"search", "--name", "lambent", "windowsize", "--sync", "800", "600"});
    act({"search", "--name", "lambent", "windowmove", "--sync", "200", "100"});
    press("p");
    look();
    expect_end();
    json remembered = settings(path("config/lambent/view.json"));
    const json expected = {{"version", 1}, {"width", 800},       {"height", 600}, {"x", 200},
                           {"y", 100},     {"maximised", false}, {"panel", false}};
    EXPECT_EQ(remembered, expected);
    open({"sphere"});
    const Screenshot again = look();
    EXPECT_EQ(again.mean({0, 0, 200, 800}), 0.0); // nothing there
    EXPECT_GT(again.mean({200, 100, 800, 500}), 20.0);
    expect_end();
    EXPECT_EQ(settings(path("config/lambent/view.json")), expected);
    // Nobody could reach it there.
    remembered["x"] = 5000;
    std::ofstream(path("config/lambent/view.json")) << remembered;
    open({"sphere"});
    look();
    expect_end();
    EXPECT_LT(settings(path("config/lambent/view.json"))["x"], 1280);
}

TEST_F(ViewWindow, ABrokenMemoryIsSaidAndForgotten)
{
    std::filesystem::create_directories(path("config/lambent"));
    std::ofstream(path("config/lambent/view.json")) << "{\"version\": 1, ";
    open({"sphere"});
    look();
    expect_end();
    EXPECT_NE(log().find("warning"), std::string::npos);
    EXPECT_EQ(settings(path("config/lambent/view.json"))["width"], 1280);
}

class ViewWithoutOpenGl : public ViewWindow {
protected:
    void SetUp() override { SetUpWith("-extension GLX"); }
};

TEST_F(ViewWithoutOpenGl, ItSaysSoInOneLine)
{
    start({"sphere"});
    EXPECT_EQ(program_->wait(30.0), 4);
    const std::string said = log();
    EXPECT_EQ(said.rfind("lambent: error: no window can be opened", 0), 0u) << said;
    EXPECT_NE(said.find("lambent serve"), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), said.size() - 1) << said;
}

TEST(View, WithoutADisplayItSaysSo)
{
    const Outcome outcome =
        run_program("env", {"-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", "LSAN_OPTIONS=detect_leaks=0",
                            LAMBENT_PROGRAM, "view", "sphere"});
    EXPECT_EQ(outcome.code, 4) << outcome.error;
    EXPECT_EQ(outcome.error.rfind("lambent: error: no window can be opened", 0), 0u) << outcome.error;
}

TEST(View, WhatCannotBeOpenedIsSaidBeforeAWindowIs)
{
    const Outcome outcome = run_program(LAMBENT_PROGRAM, {"view", "/nowhere/at-all.glb"});
    EXPECT_EQ(outcome.code, 3) << outcome.error;
    EXPECT_NE(outcome.error.find("at-all.glb"), std::string::npos);
}

} // namespace
} // namespace lambent::testing
