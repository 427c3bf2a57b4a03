// Frames in the openings of the walls. They hold no glass: light enters unchanged.
#include "kitchen/model/parts.h"
#include "kitchen/model/plan.h"

#include <glm/common.hpp>

namespace lambent::kitchen {
namespace plan {

std::vector<glm::vec3> pane_middles()
{
    std::vector<glm::vec3> middles;
    const auto across = [](const Opening& o, int pane) {
        return glm::mix(o.low.x, o.high.x, (static_cast<float>(pane) + 0.5f) / static_cast<float>(o.panes));
    };
    const auto height = [](const Opening& o) { return 0.5f * (o.low.y + o.high.y); };
    middles.reserve(static_cast<std::size_t>(window.panes + patio_door.panes));
    for (int i = 0; i < window.panes; ++i)
        middles.push_back({east, height(window), across(window, i)});
    for (int i = 0; i < patio_door.panes; ++i)
        middles.push_back({-across(patio_door, i), height(patio_door), south});
    return middles;
}

} // namespace plan

namespace {

using namespace plan;

constexpr float frame_back = -0.2f, frame_front = -0.13f; // extent of the frames within the wall

void add_bar(const Site& site, const glm::vec2& low, const glm::vec2& high)
{
    site.box(Stuff::black, {{low.x, low.y, frame_back}, {high.x, high.y, frame_front}, 0.006f},
             glm::vec3(1.6f));
}

// A frame around the opening and posts between the panes.
void add_frame(const Site& site, const Opening& o, float bar)
{
    add_bar(site, o.low, {o.high.x, o.low.y + bar});
    add_bar(site, {o.low.x, o.high.y - bar}, o.high);
    for (int i = 0; i <= o.panes; ++i) {
        const float x = glm::mix(o.low.x, o.high.x, static_cast<float>(i) / static_cast<float>(o.panes));
        const float half = i == 0 || i == o.panes ? bar : 0.5f * bar;
        add_bar(site, {glm::max(x - half, o.low.x), o.low.y}, {glm::min(x + half, o.high.x), o.high.y});
    }
}

void add_door_handle(const Site& site, const Opening& o)
{
    const float middle = 0.5f * (o.low.x + o.high.x);
    for (const float side : {-1.0f, 1.0f}) {
        const glm::vec3 points[] = {{middle + side * 0.045f, 1.02f, frame_front - 0.005f},
                                    {middle + side * 0.045f, 1.02f, frame_front + 0.055f},
                                    {middle + side * 0.17f, 1.02f, frame_front + 0.055f}};
        site.tube(Stuff::steel, {rounded_path(points, 0.02f, 6), {0.009f}, 12});
    }
}

} // namespace

void add_windows(const Site& room)
{
    const Site east_wall = room.at({east, 0.0f, 0.0f}, -90.0f);
    add_frame(east_wall, plan::window, 0.055f);
    BoxShape sill{{plan::window.low.x - 0.04f, plan::window.low.y - 0.01f, frame_front}, {}, 0.008f, 2};
    sill.high = {plan::window.high.x + 0.04f, plan::window.low.y + 0.022f, 0.045f};
    east_wall.box(Stuff::lacquer, sill, white);
    const Site south_wall = room.at({0.0f, 0.0f, south}, 180.0f);
    add_frame(south_wall, patio_door, 0.085f);
    add_door_handle(south_wall, patio_door);
    BoxShape threshold{{patio_door.low.x, -0.1f, -wall}, {patio_door.high.x, 0.012f, 0.0f}, 0.005f};
    south_wall.box(Stuff::stone, threshold);
}

} // namespace lambent::kitchen
