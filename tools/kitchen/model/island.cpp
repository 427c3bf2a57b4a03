// The island, its stools and the lamps over it.
#include "kitchen/model/cabinets.h"
#include "kitchen/model/parts.h"
#include "kitchen/model/plan.h"

#include <cmath>
#include <numbers>

namespace lambent::kitchen {
namespace {

using namespace plan;

std::vector<glm::vec3> circle(float radius, float height, int points)
{
    std::vector<glm::vec3> path;
    for (int i = 0; i <= points; ++i) {
        const float angle =
            2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(points);
        path.push_back({radius * std::sin(angle), height, radius * std::cos(angle)});
    }
    return path;
}

// White panels in frames, on the side of the stools and at both ends.
void add_panels(const Site& site, float length, int count)
{
    const float width = length / static_cast<float>(count);
    for (int i = 0; i < count; ++i) {
        const float left = width * static_cast<float>(i);
        site.box(Stuff::lacquer,
                 {{left + 0.002f, 0.1f, 0.0f}, {left + width - 0.002f, 0.878f, 0.018f}, 0.002f}, white);
        // The frame is in front of the panel.
        const auto rail = [&](const glm::vec2& low, const glm::vec2& high) {
            site.box(Stuff::lacquer, {{left + low.x, low.y, 0.01f}, {left + high.x, high.y, 0.03f}, 0.003f},
                     white);
        };
        rail({0.003f, 0.103f}, {width - 0.003f, 0.18f});
        rail({0.003f, 0.80f}, {width - 0.003f, 0.876f});
        rail({0.003f, 0.18f}, {0.075f, 0.80f});
        rail({width - 0.075f, 0.18f}, {width - 0.003f, 0.80f});
    }
}

void add_body(const Site& room)
{
    // The top overhangs by 0.3 m on the side of the stools, for knees, and a little on the others.
    const glm::vec2 low = island_low + glm::vec2(0.06f), high = island_high - glm::vec2(0.06f, 0.32f);
    room.box(Stuff::black, {{low.x + 0.05f, 0.0f, low.y + 0.05f}, {high.x - 0.05f, 0.1f, high.y - 0.05f}});
    room.box(Stuff::lacquer, {{low.x, 0.1f, low.y}, {high.x, 0.879f, high.y}}, white);
    add_panels(room.at({low.x, 0.0f, high.y}), high.x - low.x, 4);
    add_panels(room.at({high.x, 0.0f, high.y}, 90.0f), high.y - low.y, 1);
    add_panels(room.at({low.x, 0.0f, low.y}, -90.0f), high.y - low.y, 1);
    const Site back = room.at({high.x, 0.0f, low.y}, 180.0f);
    add_cabinet(back,
                {{0.0f, 0.1f}, {high.x - low.x, 0.88f}, 0.03f, 4, Fronts::drawers, Stuff::lacquer, white});
    BoxShape top{{island_low.x, counter_top - 0.045f, island_low.y},
                 {island_high.x, counter_top, island_high.y}};
    top.bevel = 0.006f;
    top.steps = 2;
    top.grain = 0;
    room.box(Stuff::marble, top);
}

} // namespace

void add_stool(const Site& site)
{
    constexpr float seat = 0.66f;
    const glm::vec2 cushion[] = {
        {0.0f, seat},          {0.165f, seat},      {0.182f, seat + 0.018f}, {0.165f, seat + 0.042f},
        {0.09f, seat + 0.05f}, {0.0f, seat + 0.05f}};
    site.lathe(Stuff::cloth, {smooth(cushion, 5), 36, 1.0f}, {0.42f, 0.23f, 0.12f});
    site.lathe(
        Stuff::wood,
        {{{0.0f, seat - 0.02f}, {0.16f, seat - 0.02f}, {0.168f, seat + 0.002f}, {0.0f, seat + 0.002f}}, 36},
        walnut);
    for (int i = 0; i < 4; ++i) {
        const float angle = 0.785398f + 1.570796f * static_cast<float>(i);
        const glm::vec3 out(std::sin(angle), 0.0f, std::cos(angle));
        site.tube(Stuff::black, {{0.12f * out + glm::vec3(0, seat - 0.015f, 0), 0.21f * out}, {0.012f}, 10});
    }
    site.tube(Stuff::brass, {circle(0.185f, 0.2f, 36), {0.009f}, 8});
    // A low back.
    std::vector<glm::vec3> back;
    for (int i = -8; i <= 8; ++i) {
        const float angle = 0.14f * static_cast<float>(i);
        back.push_back({0.185f * std::sin(angle), seat + 0.2f, 0.185f * std::cos(angle)});
    }
    site.tube(Stuff::wood, {back, {0.02f}, 10}, walnut);
    for (const float angle : {-0.8f, 0.8f})
        site.tube(Stuff::black, {{{0.15f * std::sin(angle), seat, 0.15f * std::cos(angle)},
                                  {0.185f * std::sin(angle), seat + 0.2f, 0.185f * std::cos(angle)}},
                                 {0.009f},
                                 8});
}

void add_pendant(const Site& site, const glm::vec3& tint, float cord)
{
    // A dome of sheet metal, lacquered outside, with a bulb that protrudes below.
    const glm::vec2 outside[] = {
        {0.165f, 0.0f}, {0.16f, 0.05f}, {0.13f, 0.115f}, {0.075f, 0.165f}, {0.03f, 0.19f}};
    const glm::vec2 inside[] = {
        {0.028f, 0.186f}, {0.073f, 0.161f}, {0.127f, 0.112f}, {0.157f, 0.049f}, {0.162f, 0.0f}};
    site.lathe(Stuff::lacquer, {smooth(outside, 5), 40}, tint);
    site.lathe(Stuff::lacquer, {smooth(inside, 5), 40}, white);
    site.lathe(Stuff::brass, {{{0.162f, 0.0f}, {0.165f, 0.0f}, {0.165f, -0.004f}}, 40});
    site.lathe(Stuff::brass, {{{0.032f, 0.18f}, {0.032f, 0.215f}, {0.02f, 0.235f}, {0.0f, 0.235f}}, 24});
    const glm::vec2 bulb[] = {{0.0f, 0.02f},    {0.03f, 0.027f}, {0.045f, 0.055f},
                              {0.038f, 0.088f}, {0.02f, 0.12f},  {0.018f, 0.16f}};
    site.lathe(Stuff::bulb, {smooth(bulb, 4), 24, 1.0f});
    site.tube(Stuff::black, {{{0.0f, 0.23f, 0.0f}, {0.0f, cord, 0.0f}}, {0.004f}, 8});
    site.at({0.0f, cord, 0.0f})
        .lathe(Stuff::brass, {{{0.0f, -0.025f}, {0.05f, -0.025f}, {0.055f, -0.02f}, {0.055f, 0.0f}}, 28});
}

void add_island(const Site& room)
{
    add_body(room);
    const float middle = 0.5f * (island_low.x + island_high.x);
    const float turns[] = {8.0f, -12.0f, 5.0f, -6.0f};
    for (int i = 0; i < 4; ++i)
        add_stool(
            room.at({middle + 0.6f * (static_cast<float>(i) - 1.5f), 0.0f, island_high.y + 0.06f}, turns[i]));
    for (const float x : {-0.75f, 0.0f, 0.75f})
        add_pendant(room.at({middle + x, 1.83f, -1.45f}), {0.10f, 0.17f, 0.15f}, ceiling - 1.83f);
}

} // namespace lambent::kitchen
