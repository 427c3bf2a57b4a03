#include "kitchen/model/cabinets.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lambent::kitchen {
namespace {

constexpr float gap = 0.004f, thickness = 0.02f;

// Lower drawers are higher than upper ones.
constexpr float drawer_ends[] = {0.0f, 0.4f, 0.74f, 1.0f};

void add_drawers(const Site& wall, const Cabinet& c, float left, float right)
{
    for (int i = 0; i < 3; ++i) {
        const float low = glm::mix(c.low.y, c.high.y, drawer_ends[i]);
        const float high = glm::mix(c.low.y, c.high.y, drawer_ends[i + 1]);
        const float z = c.depth - thickness;
        add_front(wall, {{left, low}, {right, high}, z, c.stuff, c.tint});
        const float middle = 0.5f * (left + right), half = glm::min(0.3f * (right - left), 0.16f);
        add_handle(wall, {middle - half, high - 0.05f, c.depth}, {middle + half, high - 0.05f, c.depth});
    }
}

// Neighbouring doors open away from each other.
void add_door(const Site& wall, const Cabinet& c, float left, float right, bool handle_right)
{
    add_front(wall, {{left, c.low.y}, {right, c.high.y}, c.depth - thickness, c.stuff, c.tint});
    const float x = handle_right ? right - 0.045f : left + 0.045f;
    float from = c.high.y - 0.27f, to = c.high.y - 0.07f;
    if (c.handles_low)
        from = c.low.y + 0.06f, to = c.low.y + 0.24f;
    if (c.fronts == Fronts::tall_doors)
        from = 0.95f, to = 1.35f;
    add_handle(wall, {x, from, c.depth}, {x, to, c.depth});
}

} // namespace

void add_front(const Site& wall, const Front& front)
{
    BoxShape board{{front.low.x + 0.5f * gap, front.low.y + 0.5f * gap, front.z},
                   {front.high.x - 0.5f * gap, front.high.y - 0.5f * gap, front.z + thickness}};
    board.bevel = 0.0025f;
    wall.box(front.stuff, board, (0.93f + 0.14f * wall.chance()) * front.tint);
}

void add_handle(const Site& wall, const glm::vec3& from, const glm::vec3& to)
{
    const glm::vec3 out(0.0f, 0.0f, 0.032f);
    wall.tube(Stuff::steel, {{from + out, to + out}, {0.0065f}, 10});
    for (const float place : {0.12f, 0.88f}) {
        const glm::vec3 foot = glm::mix(from, to, place);
        wall.tube(Stuff::steel, {{foot, foot + out}, {0.005f}, 8});
    }
}

void add_cabinet(const Site& wall, const Cabinet& c)
{
    // The body is a little smaller than its fronts, and dark where it is visible between them.
    const float body = c.depth - thickness - 0.002f;
    BoxShape inside{{c.low.x + 0.003f, c.low.y + 0.003f, 0.0f}, {c.high.x - 0.003f, c.high.y - 0.003f, body}};
    wall.box(c.stuff, inside, 0.6f * c.tint);
    const float width = (c.high.x - c.low.x) / static_cast<float>(c.columns);
    for (int i = 0; i < c.columns; ++i) {
        const float left = c.low.x + width * static_cast<float>(i);
        if (c.fronts == Fronts::drawers)
            add_drawers(wall, c, left, left + width);
        else
            add_door(wall, c, left, left + width, i % 2 == 0);
    }
}

} // namespace lambent::kitchen
