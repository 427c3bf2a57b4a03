// `lambent view` moved by mouse and keys.
#include "apps/view/input_handler.h"
#include "base/text.h"
#include "tests/scene/sliding_model.h"
#include "tests/view_window/window_fixture.h"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

namespace lambent::testing {
namespace {

TEST_F(ViewWindow, HandsMoveWhatIsSeen)
{
    open({"sphere"});
    Screenshot before = look();
    ASSERT_EQ(before.width, 1280);
    EXPECT_GT(before.mean(picture_area), 20.0);
    const auto expect_change = [&](const char* what, double least) {
        Screenshot after = look_changed(before, picture_area, least);
        EXPECT_GT(after.difference(before, picture_area), least) << what;
        before = std::move(after);
    };
    drag("1", nullptr);
    expect_change("orbit", 3.0);
    drag("3", nullptr);
    expect_change("pan", 3.0);
    drag("1", "shift");
    expect_change("environment", 1.0);
    act({"mousemove", "400", "300", "click", "5", "sleep", "0.1", "click", "5"});
    expect_change("dolly", 1.0);
    act({"mousemove", "600", "360", "sleep", "0.1", "click", "--repeat", "2", "--delay", "100", "1"});
    expect_change("double click", 1.0);
    expect_end();
    EXPECT_EQ(log(), "");
}

TEST_F(ViewWindow, EveryKeyOfTheListDoesWhatItSays)
{
    open({"sphere"});
    act({"mousemove", "1279", "799"});
    Screenshot before = look();
    const auto expect_change = [&](const char* key, const Screenshot::Area& area, double least) {
        press(key);
        Screenshot after = look_changed(before, area, least);
        EXPECT_GT(after.difference(before, area), least) << key;
        before = std::move(after);
    };
    for (const char* key : {"Right", "Left", "Up", "Down", "shift+Right", "shift+Down", "plus", "minus",
                            "bracketleft", "bracketright", "e", "shift+e"})
        expect_change(key, picture_area, 0.5);
    press("shift+Right");
    before = look();
    expect_change("f", picture_area, 0.5); // the sphere is still in the middle, its surface is nearer
    expect_change("r", picture_area, 0.5);
    for (const char* key : {"F1", "F1", "question", "Escape"})
        expect_change(key, picture_area, 1.0);
    for (const char* key : {"p", "p"})
        expect_change(key, panel_area, 10.0);
    expect_change("c", message_area, 5.0);
    expect_saved({"sphere", "--size", "1280x720"});
}

// The keys that the list names and those that do something come from one table.
TEST(ViewKeys, ATableHasThemAllOnce)
{
    std::string characters;
    int actions = 0;
    for (const view_window::Shortcut& shortcut : view_window::shortcuts()) {
        EXPECT_FALSE(shortcut.keys.empty() || shortcut.meaning.empty());
        const bool has_keys = !shortcut.characters.empty() || shortcut.others[0] != 0;
        EXPECT_EQ(shortcut.act != nullptr, has_keys) << shortcut.keys;
        actions += shortcut.act != nullptr;
        for (const char c : shortcut.characters) {
            EXPECT_EQ(characters.find(c), std::string::npos) << c;
            characters += c;
        }
    }
    EXPECT_EQ(actions, 13);
}

TEST_F(ViewWindow, SpacePlaysAndStops)
{
    const std::string model = desktop_->folder().path("moving.glb");
    const std::vector<std::uint8_t> bytes = scene::test::sliding_model();
    std::ofstream(model, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    open({model});
    const Screenshot still = look();
    press("space");
    std::this_thread::sleep_for(std::chrono::milliseconds(700 * patience));
    const Screenshot one = desktop_->look();
    std::this_thread::sleep_for(std::chrono::milliseconds(400 * patience));
    EXPECT_GT(desktop_->look().difference(one, picture_area), 0.5);
    press("space");
    const Screenshot stopped = look();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_EQ(desktop_->look().rgb == stopped.rgb, true);
    EXPECT_GT(stopped.difference(still, picture_area), 0.5);
}

TEST_F(ViewWindow, ThePanelsSliderChangesTheExposure)
{
    open({"sphere"});
    const Screenshot first = look();
    const double before = first.mean(picture_area);
    act({"mousemove", text(exposure.x), text(exposure.y), "sleep", "0.2", "mousedown", "1", "sleep", "0.2",
         "mousemove", text(exposure_more.x), text(exposure_more.y), "sleep", "0.2", "mouseup", "1"});
    EXPECT_GT(look_changed(first, picture_area, 10.0).mean(picture_area), before + 10.0);
    click(exposure, "3"); // its default
    EXPECT_NEAR(look_like(first, picture_area, 2.0).mean(picture_area), before, 2.0);
    // Arrows are the panel's while it is used, until Escape.
    press("Escape");
    const Screenshot still = look();
    press("Right");
    EXPECT_GT(look_changed(still, picture_area, 0.5).difference(still, picture_area), 0.5);
}

TEST_F(ViewWindow, WhatIsSavedIsWhatTheCommandDraws)
{
    open({"teapot"});
    look();
    drag("1", nullptr);
    look();
    const std::string first = saved("picture.png");
    EXPECT_FALSE(first.empty()) << log();
    EXPECT_EQ(saved("picture-2.png") == first, true); // nothing is written over
    std::filesystem::remove(path("picture.png"));
    // Half a turn over the window's height of 720: 100 pixels are 25 degrees, 20 down are 5.
    expect_saved({"teapot", "--size", "1280x720", "--camera", "5,25"});
}

} // namespace
} // namespace lambent::testing
