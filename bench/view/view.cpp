// From the start of `lambent view` to its window and to the first picture in it, on a screen that nobody sees.
#include "base/text.h"
#include "tests/view_window/desktop.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <thread>

namespace {

using namespace lambent::testing;
using Clock = std::chrono::steady_clock;

struct Start {
    double window_ms = 0.0, picture_ms = 0.0;
};

// A place left of the panel: black before there is a window, of one grey until there is a picture.
constexpr Screenshot::Area place = {100, 100, 600, 8};

bool has_window(const Screenshot& shot)
{
    return shot.width > 0 && shot.mean(place) > 1.0;
}

bool has_picture(const Screenshot& shot)
{
    if (shot.width == 0)
        return false;
    const auto row = shot.rgb.begin() + 3 * (place.y * shot.width + place.x);
    const auto [least, most] = std::minmax_element(row, row + 3 * place.width);
    return *most - *least > 30;
}

double ms_until(const Desktop& desktop, Clock::time_point start, bool (*there)(const Screenshot&))
{
    const auto ms = [&] { return std::chrono::duration<double, std::milli>(Clock::now() - start).count(); };
    while (!there(desktop.look(place.y + place.height)) && ms() < 60000.0)
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    return ms();
}

Start measure(const Desktop& desktop)
{
    const Clock::time_point start = Clock::now();
    const Running program({"env", lambent::text("DISPLAY=", desktop.display()),
                           lambent::text("XDG_CONFIG_HOME=", desktop.folder().path("config")),
                           lambent::text("XDG_CACHE_HOME=", cache_home()), LAMBENT_PROGRAM, "view", "grid"},
                          desktop.folder().path("log"));
    const double window = ms_until(desktop, start, has_window);
    return {window, ms_until(desktop, start, has_picture)};
}

double median(std::vector<Start> starts, double Start::*member)
{
    std::sort(starts.begin(), starts.end(),
              [&](const Start& a, const Start& b) { return a.*member < b.*member; });
    return starts[starts.size() / 2].*member;
}

} // namespace

int main()
{
    constexpr int rounds = 7;
    std::vector<Start> starts;
    for (int i = 0; i < rounds; ++i) {
        std::string why;
        const std::unique_ptr<Desktop> desktop = Desktop::open(why);
        if (!desktop) {
            std::printf("skipped: %s\n", why.c_str());
            return 0;
        }
        starts.push_back(measure(*desktop));
    }
    std::printf("| grid, kitchen, 1280x720, from the command | median | most |\n| --- | --- | --- |\n");
    for (const auto& [what, member] : {std::pair{"to the window, ms", &Start::window_ms},
                                       std::pair{"to the first picture in it, ms", &Start::picture_ms}}) {
        double most = 0.0;
        for (const Start& start : starts)
            most = std::max(most, start.*member);
        std::printf("| %s | %.0f | %.0f |\n", what, median(starts, member), most);
    }
}
