// `lambent view` on a screen that nobody sees, moved by xdotool.
#pragma once

#include "tests/view_window/desktop.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lambent::testing {

/// The picture without panel and lines, and where lines of trouble begin. The window is 1280 by 720 unless it is said.
constexpr Screenshot::Area picture_area = {0, 0, 900, 600}, message_area = {0, 625, 900, 35},
                           panel_area = {925, 0, 355, 655};

/// Where the panel has its controls, for the default letters and a built-in scene without lights.
struct Spot {
    int x, y;
};
constexpr Spot model_list = {1050, 40}, path_field = {980, 90}, open_button = {1135, 90},
               add_sun = {968, 162}, add_lamp = {1060, 162}, exposure = {1070, 212},
               exposure_more = {1085, 212};

std::string contents(const std::string& path);

class ViewWindow : public ::testing::Test {
protected:
    void SetUp() override { SetUpWith(""); }
    void SetUpWith(const std::string& more);

    /// The program's words after "view". Its settings are in the desktop's folder, and it runs there or in one below.
    void start(const std::vector<std::string>& words, const std::string& folder = ".");
    /// And waits until its window is there and has the keys.
    /// Without bounces of light unless the words say otherwise, so that the picture comes to rest.
    void open(std::vector<std::string> words, const std::string& folder = ".");

    void act(const std::vector<std::string>& words) const;
    void press(const char* key) const { act({"key", key}); }
    void click(Spot spot, const char* button = "1") const;
    void drag(const char* button, const char* modifier) const;
    void type_path(const std::string& path) const;

    Screenshot look() const { return desktop_->look_at_rest(30.0, *program_); }

    /// The screen at rest, after what is expected of it is seen, for which these wait. What is not seen in time is
    /// for the caller to find.
    Screenshot look_until(const std::function<bool(const Screenshot&)>& is_seen) const;
    /// A part of it has changed by more than `least`.
    Screenshot look_changed(const Screenshot& before, const Screenshot::Area& area, double least) const;
    /// A part of it is within `most` of another screen.
    Screenshot look_like(const Screenshot& other, const Screenshot::Area& area, double most) const;
    /// A line of trouble is there.
    Screenshot look_said() const;
    std::string path(const std::string& name) const { return desktop_->folder().path(name); }
    std::string log() const { return contents(path("view.log")); }
    /// Whether the window has this name's title, for which it waits.
    bool is_titled(const std::string& name) const;

    /// Presses S; what is in the file then, once it is there; "" if it does not come.
    std::string saved(const std::string& name);

    /// Presses S, ends the program and expects the file to be what `lambent render` writes by these words.
    void expect_saved(std::vector<std::string> render);
    void expect_end();

    std::unique_ptr<Desktop> desktop_;
    std::unique_ptr<Running> program_;
};

} // namespace lambent::testing
