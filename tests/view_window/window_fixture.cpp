#include "tests/view_window/window_fixture.h"

#include "base/text.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

namespace lambent::testing {

std::string contents(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void ViewWindow::SetUpWith(const std::string& more)
{
    std::string why;
    desktop_ = Desktop::open(why, more);
    if (!desktop_) {
        ASSERT_EQ(std::getenv("LAMBENT_REQUIRE_DISPLAY"), nullptr) << why;
        GTEST_SKIP() << why;
    }
}

// Drivers keep some memory to the end of the program.
void ViewWindow::start(const std::vector<std::string>& words, const std::string& folder)
{
    std::vector<std::string> all = {"env",
                                    text("--chdir=", path(folder)),
                                    text("DISPLAY=", desktop_->display()),
                                    text("XDG_CONFIG_HOME=", path("config")),
                                    text("XDG_CACHE_HOME=", cache_home()),
                                    "LSAN_OPTIONS=detect_leaks=0",
                                    LAMBENT_PROGRAM,
                                    "view"};
    all.insert(all.end(), words.begin(), words.end());
    program_ = std::make_unique<Running>(all, path("view.log"));
}

void ViewWindow::open(std::vector<std::string> words, const std::string& folder)
{
    if (std::find(words.begin(), words.end(), "--bounces") == words.end())
        words.insert(words.end(), {"--bounces", "0"});
    start(words, folder);
    ASSERT_TRUE(desktop_->act({"search", "--sync", "--onlyvisible", "--name", "lambent"})) << log();
    act({"search", "--name", "lambent", "windowfocus"});
}

void ViewWindow::act(const std::vector<std::string>& words) const
{
    EXPECT_TRUE(desktop_->act(words)) << words.front();
}

void ViewWindow::click(Spot spot, const char* button) const
{
    act({"mousemove", text(spot.x), text(spot.y), "sleep", "0.2", "mousedown", button, "sleep", "0.2",
         "mouseup", button, "sleep", "0.2"});
}

void ViewWindow::drag(const char* button, const char* modifier) const
{
    if (modifier)
        act({"keydown", modifier});
    act({"mousemove", "300", "300", "sleep", "0.1", "mousedown", button, "sleep", "0.1"});
    for (const char* x : {"330", "360", "400"})
        act({"mousemove", x, "320", "sleep", "0.1"});
    act({"mouseup", button});
    if (modifier)
        act({"keyup", modifier});
}

void ViewWindow::type_path(const std::string& path) const
{
    click(path_field);
    act({"key", "ctrl+a", "sleep", "0.2", "type", "--delay", "30", path});
    act({"key", "Return"});
}

bool ViewWindow::is_titled(const std::string& name) const
{
    for (int i = 0; i < 50 * patience; ++i) {
        if (desktop_->act({"search", "--onlyvisible", "--name", text("^", name, " - lambent")}))
            return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
    return false;
}

void ViewWindow::expect_end()
{
    press("ctrl+q");
    EXPECT_EQ(program_->wait(60.0), 0) << log();
}

Screenshot ViewWindow::look_until(const std::function<bool(const Screenshot&)>& is_seen) const
{
    for (int i = 0; i < 100 * patience && !is_seen(desktop_->look()); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
    return look();
}

Screenshot ViewWindow::look_changed(const Screenshot& before, const Screenshot::Area& area,
                                    double least) const
{
    return look_until([&](const Screenshot& now) { return now.difference(before, area) > least; });
}

Screenshot ViewWindow::look_like(const Screenshot& other, const Screenshot::Area& area, double most) const
{
    return look_until([&](const Screenshot& now) { return now.difference(other, area) < most; });
}

Screenshot ViewWindow::look_said() const
{
    return look_until([](const Screenshot& now) { return now.redness(message_area) > 0.005; });
}

std::string ViewWindow::saved(const std::string& name)
{
    press("s");
    for (int i = 0; i < 600 * patience && !std::filesystem::exists(path(name)); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return contents(path(name)); // written beside and then renamed: all of it is there
}

void ViewWindow::expect_saved(std::vector<std::string> render)
{
    saved("picture.png");
    expect_end();
    render.insert(render.begin(), "render");
    render.insert(render.end(), {"--bounces", "0", "-o", path("drawn.png")});
    const Outcome drawn = run_program(LAMBENT_PROGRAM, render);
    ASSERT_EQ(drawn.code, 0) << drawn.error;
    ASSERT_TRUE(std::filesystem::exists(path("picture.png"))) << log();
    EXPECT_TRUE(contents(path("picture.png")) == contents(path("drawn.png")));
}

} // namespace lambent::testing
