// The dining area: table, chairs, lamp, rug, pictures.
#include "kitchen/model/parts.h"
#include "kitchen/model/plan.h"

#include <cmath>

namespace lambent::kitchen {
namespace {

using namespace plan;

constexpr glm::vec3 table(-1.2f, 0.0f, 1.2f);
constexpr float table_top = 0.75f;

void add_table(const Site& site)
{
    site.lathe(Stuff::wood,
               {{{0.0f, table_top - 0.035f},
                 {0.55f, table_top - 0.035f},
                 {0.575f, table_top - 0.02f},
                 {0.58f, table_top - 0.004f},
                 {0.576f, table_top},
                 {0.0f, table_top}},
                64},
               walnut);
    const glm::vec2 foot[] = {
        {0.30f, 0.0f}, {0.30f, 0.015f},           {0.14f, 0.04f}, {0.055f, 0.12f}, {0.045f, 0.3f},
        {0.05f, 0.6f}, {0.12f, table_top - 0.03f}};
    site.lathe(Stuff::black, {smooth(foot, 6), 40});
}

// A framed picture of a pear or of three lemons. The site is its centre on a wall.
void add_picture(const Site& wall, const glm::vec2& half, int kind)
{
    wall.box(Stuff::wood,
             {{-half.x - 0.02f, -half.y - 0.02f, 0.0f}, {half.x + 0.02f, half.y + 0.02f, 0.022f}, 0.004f},
             walnut);
    wall.box(Stuff::cloth, {{-half.x, -half.y, 0.01f}, {half.x, half.y, 0.024f}}, white);
    if (kind == 0) {
        // A pear.
        const glm::vec2 pear[] = {{0.0f, -0.13f},  {0.07f, -0.12f}, {0.1f, -0.06f}, {0.075f, 0.0f},
                                  {0.045f, 0.07f}, {0.02f, 0.12f},  {0.0f, 0.125f}};
        wall.at({0.0f, 0.0f, 0.0f}).lathe(Stuff::fruit, {smooth(pear, 5), 32, 1.2f}, {0.60f, 0.62f, 0.16f});
    } else {
        // Three cut lemons.
        for (int i = 0; i < 3; ++i)
            wall.at({0.0f, 0.12f - 0.12f * static_cast<float>(i), 0.022f})
                .tipped(90.0f)
                .lathe(Stuff::cloth, {{{0.0f, 0.0f}, {0.045f, 0.0f}, {0.045f, 0.004f}, {0.0f, 0.004f}}, 32},
                       {0.95f, 0.70f, 0.12f});
    }
}

} // namespace

void add_chair(const Site& site)
{
    constexpr float seat = 0.45f;
    site.box(Stuff::wood, {{-0.21f, seat - 0.03f, -0.2f}, {0.21f, seat, 0.2f}, 0.013f, 3, 2}, pale_oak);
    for (const float x : {-0.17f, 0.17f})
        for (const float z : {-0.16f, 0.16f})
            site.tube(Stuff::wood,
                      {{{x, seat - 0.02f, z}, {1.15f * x, 0.0f, 1.2f * z}}, {0.018f, 0.012f}, 10}, pale_oak);
    // A back of sticks and a bent rail.
    std::vector<glm::vec3> rail;
    for (int i = -6; i <= 6; ++i) {
        const float t = static_cast<float>(i) / 6.0f;
        rail.push_back({0.22f * t, 0.82f, 0.26f - 0.06f * t * t});
    }
    site.tube(Stuff::wood, {rail, {0.022f}, 12}, pale_oak);
    for (int i = -2; i <= 2; ++i) {
        const float t = 0.45f * static_cast<float>(i);
        site.tube(
            Stuff::wood,
            {{{0.16f * t, seat - 0.01f, 0.17f}, {0.21f * t, 0.82f, 0.26f - 0.06f * t * t}}, {0.009f}, 8},
            pale_oak);
    }
}

void add_clock(const Site& wall)
{
    const Site dial = wall.tipped(90.0f);
    dial.lathe(Stuff::cloth, {{{0.0f, 0.015f}, {0.15f, 0.015f}, {0.15f, 0.02f}, {0.0f, 0.02f}}, 48}, white);
    dial.lathe(
        Stuff::black,
        {{{0.0f, 0.0f}, {0.17f, 0.0f}, {0.17f, 0.035f}, {0.155f, 0.035f}, {0.15f, 0.018f}, {0.0f, 0.018f}},
         56});
    for (int hour = 0; hour < 12; ++hour) {
        const float angle = 0.5235988f * static_cast<float>(hour), half = hour % 3 == 0 ? 0.006f : 0.003f;
        const glm::vec3 at(0.128f * std::sin(angle), 0.02f, -0.128f * std::cos(angle));
        dial.at(at, -30.0f * static_cast<float>(hour))
            .box(Stuff::black, {{-half, -0.001f, -0.014f}, {half, 0.002f, 0.014f}});
    }
    // Ten past ten. A positive turn is counter-clockwise seen from the room.
    dial.at({0.0f, 0.022f, 0.0f}, 55.0f)
        .box(Stuff::black, {{-0.005f, 0.0f, -0.08f}, {0.005f, 0.003f, 0.02f}});
    dial.at({0.0f, 0.026f, 0.0f}, -60.0f)
        .box(Stuff::black, {{-0.0035f, 0.0f, -0.12f}, {0.0035f, 0.003f, 0.025f}});
    dial.lathe(Stuff::brass, {{{0.0f, 0.02f}, {0.008f, 0.02f}, {0.007f, 0.032f}, {0.0f, 0.033f}}, 16});
}

void add_dining(const Site& room)
{
    const Site site = room.at(table);
    add_table(site);
    for (const float turn : {25.0f, 150.0f, 265.0f})
        add_chair(site.at(glm::vec3(0.0f), turn).at({0.0f, 0.0f, 0.62f}));
    add_pendant(room.at({table.x, 1.72f, table.z}), {0.80f, 0.56f, 0.20f}, ceiling - 1.72f);
    add_vase(site.at({0.1f, table_top, 0.12f}), {0.90f, 0.88f, 0.84f});
    for (const float turn : {25.0f, 150.0f}) {
        const Site place = site.at(glm::vec3(0.0f), turn).at({0.0f, table_top, 0.38f});
        add_plate(place, white);
        add_bowl(place.at({0.0f, 0.009f, 0.0f}), {0.45f, 0.58f, 0.62f});
        add_cup(place.at({0.17f, 0.0f, -0.1f}, 30.0f), {0.45f, 0.58f, 0.62f});
    }
    // A box that covers the unit square of the texture.
    BoxShape rug{{0.0f, 0.0f, 0.0f}, {1.0f, 0.006f, 1.0f}, 0.002f, 1, 2};
    room.at({-2.0f, 0.0f, 0.4f}).scaled(1.6f).box(Stuff::rug, rug);
    const Site wall = room.at({0.0f, 0.0f, south}, 180.0f);
    add_picture(wall.at({0.75f, 1.65f, 0.0f}), {0.19f, 0.25f}, 0);
    add_picture(wall.at({1.4f, 1.65f, 0.0f}), {0.19f, 0.25f}, 1);
}

} // namespace lambent::kitchen
