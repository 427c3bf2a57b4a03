// Fridge, oven, hood, cooktop and sink.
#include "kitchen/model/cabinets.h"
#include "kitchen/model/parts.h"
#include "kitchen/model/plan.h"

#include <cmath>
#include <numbers>

namespace lambent::kitchen {
namespace {

constexpr float two_pi = 2.0f * std::numbers::pi_v<float>;

// A flat ring lying on the site.
void add_ring(const Site& site, Stuff stuff, float radius, float thickness)
{
    constexpr float height = 0.0008f;
    site.lathe(stuff, {{{radius - thickness, 0.0f},
                        {radius, 0.0f},
                        {radius, height},
                        {radius - thickness, height},
                        {radius - thickness, 0.0f}},
                       40});
}

void add_knob(const Site& front, const glm::vec3& place)
{
    front.at(place).tipped(90.0f).lathe(
        Stuff::steel, {{{0.0f, 0.0f}, {0.02f, 0.0f}, {0.019f, 0.02f}, {0.016f, 0.023f}, {0.0f, 0.023f}}, 24});
}

// A long bar handle in front of the door.
void add_grip(const Site& front, const glm::vec3& from, const glm::vec3& to)
{
    const glm::vec3 out(0.0f, 0.0f, 0.05f);
    const glm::vec3 points[] = {from, from + out, to + out, to};
    front.tube(Stuff::steel, {rounded_path(points, 0.03f, 6), {0.011f}, 12});
}

} // namespace

void add_fridge(const Site& site)
{
    constexpr float half = 0.455f, depth = 0.66f, split = 0.72f, top = 1.95f;
    site.box(Stuff::black, {{-half, 0.02f, 0.0f}, {half, top, depth - 0.03f}}, glm::vec3(2.0f));
    const auto door = [&](const glm::vec2& low, const glm::vec2& high) {
        BoxShape shape{{low.x + 0.003f, low.y + 0.003f, depth - 0.06f},
                       {high.x - 0.003f, high.y - 0.003f, depth}};
        shape.bevel = 0.012f;
        shape.steps = 3;
        site.box(Stuff::steel, shape);
    };
    door({-half, split}, {0.0f, top});
    door({0.0f, split}, {half, top});
    door({-half, 0.39f}, {half, split});
    door({-half, 0.05f}, {half, 0.39f});
    for (const float side : {-0.05f, 0.05f})
        add_grip(site, {side, split + 0.12f, depth}, {side, split + 0.85f, depth});
    for (const float y : {0.66f, 0.33f})
        add_grip(site, {-0.36f, y, depth}, {0.36f, y, depth});
    // A dispenser for water and ice.
    BoxShape niche{{-0.33f, 1.2f, depth - 0.01f}, {-0.13f, 1.52f, depth + 0.004f}, 0.003f};
    site.box(Stuff::black_glass, niche);
}

void add_oven(const Site& site)
{
    constexpr float half = 0.295f;
    BoxShape door{{-half, 0.0f, -0.02f}, {half, 0.46f, 0.022f}, 0.004f};
    site.box(Stuff::black_glass, door);
    site.box(Stuff::steel, {{-half, 0.463f, -0.02f}, {half, 0.58f, 0.022f}, 0.004f});
    site.box(Stuff::black_glass, {{-0.09f, 0.492f, 0.015f}, {0.09f, 0.552f, 0.024f}, 0.002f});
    for (const float x : {-0.21f, 0.21f})
        add_knob(site, {x, 0.522f, 0.022f});
    add_grip(site, {-0.24f, 0.415f, 0.022f}, {0.24f, 0.415f, 0.022f});
    // The frame of the window: a line of steel in the glass.
    for (const float y : {0.06f, 0.34f})
        site.box(Stuff::steel, {{-0.22f, y, 0.02f}, {0.22f, y + 0.004f, 0.0235f}, 0.001f});
    for (const float x : {-0.22f, 0.216f})
        site.box(Stuff::steel, {{x, 0.06f, 0.02f}, {x + 0.004f, 0.344f, 0.0235f}, 0.001f});
}

void add_hood(const Site& site)
{
    // A flat body, a slope of thin boxes and the duct up to the ceiling.
    site.box(Stuff::steel, {{-0.45f, 0.0f, 0.008f}, {0.45f, 0.07f, 0.50f}, 0.006f, 2, 0});
    constexpr int layers = 9;
    for (int i = 0; i < layers; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(layers);
        const float half = 0.43f - 0.27f * std::sqrt(t), depth = 0.48f - 0.18f * std::sqrt(t);
        const float y = 0.07f + 0.17f * t;
        site.box(Stuff::steel, {{-half, y - 0.002f, 0.008f}, {half, y + 0.02f, depth}, 0.003f, 1, 0});
    }
    site.box(Stuff::steel, {{-0.15f, 0.2f, 0.008f}, {0.15f, plan::ceiling - 1.65f, 0.29f}, 0.004f, 2});
    site.box(Stuff::black, {{-0.38f, -0.006f, 0.06f}, {0.38f, 0.002f, 0.44f}, 0.002f});
    for (const float x : {-0.3f, 0.3f})
        site.at({x, 0.0f, 0.25f})
            .lathe(Stuff::strip, {{{0.0f, -0.009f}, {0.04f, -0.009f}, {0.043f, 0.0f}}, 24});
    for (int i = 0; i < 4; ++i)
        site.at({-0.06f + 0.04f * static_cast<float>(i), 0.035f, 0.5f})
            .tipped(90.0f)
            .lathe(Stuff::black,
                   {{{0.0f, -0.002f}, {0.009f, -0.002f}, {0.009f, 0.003f}, {0.0f, 0.003f}}, 16});
}

void add_cooktop(const Site& site)
{
    BoxShape glass{{-0.40f, -0.01f, -0.26f}, {0.40f, 0.007f, 0.26f}, 0.003f};
    site.box(Stuff::black_glass, glass);
    const glm::vec3 rings[] = {
        {-0.22f, 0.007f, -0.11f}, {0.22f, 0.007f, -0.11f}, {-0.22f, 0.007f, 0.11f}, {0.22f, 0.007f, 0.11f}};
    for (int i = 0; i < 4; ++i)
        add_ring(site.at(rings[i]), Stuff::steel, i % 3 == 0 ? 0.105f : 0.085f, 0.003f);
}

void add_sink(const Site& site)
{
    // The basin: floor and four sides of sheet steel.
    constexpr float x = 0.38f, z = 0.2f, deep = 0.2f, sheet = 0.012f;
    site.box(Stuff::steel, {{-x, -deep, -z}, {x, -deep + sheet, z}, 0.002f});
    for (const float side : {-1.0f, 1.0f}) {
        const float a = side * x, b = side * (x - sheet), c = side * z, d = side * (z - sheet);
        site.box(Stuff::steel, {{std::min(a, b), -deep, -z}, {std::max(a, b), 0.003f, z}, 0.003f, 2});
        site.box(Stuff::steel, {{-x, -deep, std::min(c, d)}, {x, 0.003f, std::max(c, d)}, 0.003f, 2});
    }
    site.at({0.0f, -deep + sheet, 0.0f})
        .lathe(Stuff::chrome, {{{0.0f, 0.002f}, {0.03f, 0.002f}, {0.045f, 0.004f}, {0.047f, 0.0f}}, 24});
    // The tap: a column, a swan's neck, a lever.
    const Site tap = site.at({0.0f, 0.0f, -0.255f});
    tap.lathe(Stuff::chrome, {{{0.0f, 0.0f},
                               {0.03f, 0.0f},
                               {0.03f, 0.008f},
                               {0.021f, 0.014f},
                               {0.021f, 0.09f},
                               {0.016f, 0.1f},
                               {0.0f, 0.1f}},
                              24});
    std::vector<glm::vec3> neck{{0.0f, 0.09f, 0.0f}, {0.0f, 0.30f, 0.0f}};
    for (int i = 0; i <= 16; ++i) {
        const float angle = 0.5f * two_pi * static_cast<float>(i) / 16.0f;
        neck.push_back({0.0f, 0.32f + 0.1f * std::sin(angle), 0.1f - 0.1f * std::cos(angle)});
    }
    neck.push_back({0.0f, 0.24f, 0.2f});
    tap.tube(Stuff::chrome, {neck, {0.0125f}, 16});
    tap.at({0.0f, 0.24f, 0.2f})
        .lathe(Stuff::chrome,
               {{{0.0f, -0.03f}, {0.015f, -0.03f}, {0.016f, 0.0f}, {0.016f, 0.03f}, {0.0f, 0.03f}}, 20});
    const glm::vec3 lever[] = {{0.015f, 0.06f, 0.0f}, {0.05f, 0.065f, 0.0f}, {0.11f, 0.1f, 0.0f}};
    tap.tube(Stuff::chrome, {smooth(lever, 6), {0.007f}, 12});
}

} // namespace lambent::kitchen
