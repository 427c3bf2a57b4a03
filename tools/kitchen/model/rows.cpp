// The rows of cabinets along the walls, their worktops, tiles and shelves.
#include "kitchen/model/cabinets.h"
#include "kitchen/model/parts.h"
#include "kitchen/model/plan.h"

#include <glm/common.hpp>

namespace lambent::kitchen {
namespace {

using namespace plan;

constexpr float kick = 0.1f, front = counter_depth - 0.02f;

// The dark plinth below a row of cabinets.
void add_toe_kick(const Site& wall, float from, float to)
{
    wall.box(Stuff::black, {{from, 0.0f, 0.0f}, {to, kick, front - 0.06f}});
}

void add_base(const Site& wall, const glm::vec2& ends, int columns, Fronts fronts)
{
    add_toe_kick(wall, ends.x, ends.y);
    add_cabinet(wall,
                {{ends.x, kick}, {ends.y, counter_top - slab}, front, columns, fronts, Stuff::wood, oak});
}

void add_worktop(const Site& wall, const glm::vec2& ends, const glm::vec2& depths)
{
    BoxShape top{{ends.x, counter_top - slab, depths.x}, {ends.y, counter_top, depths.y}, 0.004f};
    wall.box(Stuff::stone, top);
}

// Glazed tiles, each a little different, rows shifted by half a tile, over grout.
void add_tiles(const Site& wall, const glm::vec2& low, const glm::vec2& high, const glm::vec3& tint)
{
    constexpr float width = 0.2f, height = 0.1f, joint = 0.0015f;
    wall.box(Stuff::plaster, {{low.x, low.y, -0.01f}, {high.x, high.y, 0.003f}}, glm::vec3(0.8f));
    int row = 0;
    for (float y = low.y; y < high.y - 0.02f; y += height, ++row)
        for (float x = low.x - (row % 2 == 0 ? 0.0f : 0.5f * width); x < high.x - 0.02f; x += width) {
            BoxShape tile{
                {glm::max(x, low.x) + joint, y + joint, -0.002f},
                {glm::min(x + width, high.x) - joint, glm::min(y + height, high.y) - joint, 0.008f}};
            tile.bevel = 0.002f;
            if (tile.high.x - tile.low.x > 0.02f)
                wall.box(Stuff::tile, tile, (0.88f + 0.2f * wall.chance()) * tint);
        }
}

void add_north_row(const Site& room)
{
    const Site wall = room.at({0.0f, 0.0f, north});
    const glm::vec3 soft_green(0.60f, 0.72f, 0.68f);
    add_fridge(wall.at({-2.32f, 0.0f, 0.0f}));
    add_cabinet(wall,
                {{-2.78f, 1.97f}, {-1.86f, cabinet_top}, 0.62f, 2, Fronts::doors, Stuff::wood, oak, true});
    // A tall cabinet with the oven at hand height.
    add_toe_kick(wall, -1.85f, -1.23f);
    add_cabinet(wall, {{-1.85f, kick}, {-1.23f, 0.86f}, 0.62f, 1, Fronts::drawers, Stuff::wood, oak});
    add_cabinet(wall,
                {{-1.85f, 1.46f}, {-1.23f, cabinet_top}, 0.62f, 1, Fronts::doors, Stuff::wood, oak, true});
    wall.box(Stuff::wood, {{-1.85f, 0.86f, 0.0f}, {-1.23f, 1.46f, 0.58f}}, 0.6f * oak);
    add_oven(wall.at({-1.54f, 0.87f, 0.60f}));
    add_base(wall, {-1.22f, -0.25f}, 2, Fronts::drawers);
    add_base(wall, {-0.25f, 0.75f}, 2, Fronts::doors);
    add_base(wall, {0.75f, east - counter_depth}, 3, Fronts::drawers);
    add_worktop(wall, {-1.22f, east}, {0.0f, counter_depth});
    add_tiles(wall, {-1.22f, counter_top}, {east, 1.5f}, soft_green);
    add_tiles(wall, {-0.3f, 1.5f}, {0.8f, cabinet_top}, soft_green);
    add_cabinet(wall,
                {{-1.22f, 1.5f}, {-0.3f, cabinet_top}, 0.35f, 2, Fronts::doors, Stuff::wood, oak, true});
    add_cooktop(wall.at({cooktop, counter_top, 0.5f * counter_depth}));
    add_hood(wall.at({cooktop, 1.65f, 0.0f}));
}

void add_east_row(const Site& room)
{
    const Site wall = room.at({east, 0.0f, 0.0f}, -90.0f);
    const float from = north + counter_depth, to = 0.93f;
    add_base(wall, {from, -1.3f}, 3, Fronts::doors);
    add_base(wall, {-1.3f, -0.3f}, 2, Fronts::doors);
    add_base(wall, {-0.3f, to}, 2, Fronts::drawers);
    // The worktop around the sink.
    constexpr float half = 0.38f;
    add_worktop(wall, {from, sink - half}, {0.0f, counter_depth});
    add_worktop(wall, {sink + half, to}, {0.0f, counter_depth});
    add_worktop(wall, {sink - half, sink + half}, {0.0f, 0.13f});
    add_worktop(wall, {sink - half, sink + half}, {0.53f, counter_depth});
    add_sink(wall.at({sink, counter_top, 0.33f}));
    add_tiles(wall, {north, counter_top}, {to, plan::window.low.y - 0.01f}, {0.60f, 0.72f, 0.68f});
    // A tall larder beside the patio door.
    add_toe_kick(wall, 1.1f, 2.1f);
    add_cabinet(wall, {{1.1f, kick}, {2.1f, cabinet_top}, 0.5f, 2, Fronts::tall_doors, Stuff::wood, oak});
}

void add_shelf(const Site& wall, const glm::vec2& ends, float height)
{
    BoxShape board{{ends.x, height - 0.035f, 0.0f}, {ends.y, height, 0.27f}, 0.004f, 1, 0};
    wall.box(Stuff::wood, board, oak);
    for (const float x : {ends.x + 0.2f, 0.5f * (ends.x + ends.y), ends.y - 0.2f}) {
        wall.box(Stuff::brass,
                 {{x - 0.01f, height - 0.15f, 0.0f}, {x + 0.01f, height - 0.035f, 0.008f}, 0.002f});
        wall.box(Stuff::brass,
                 {{x - 0.01f, height - 0.043f, 0.0f}, {x + 0.01f, height - 0.035f, 0.23f}, 0.002f});
    }
}

void add_west_row(const Site& room)
{
    const Site wall = room.at({west, 0.0f, 0.0f}, 90.0f);
    add_base(wall, {-1.2f, 1.7f}, 4, Fronts::drawers);
    add_worktop(wall, {-1.22f, 1.72f}, {0.0f, counter_depth});
    add_tiles(wall, {-1.22f, counter_top}, {1.72f, 1.42f}, {0.98f, 0.96f, 0.92f});
    add_shelf(wall, {-1.2f, 1.6f}, 1.50f);
    add_shelf(wall, {-1.2f, 1.6f}, 1.90f);
}

// Light strips below the cabinets and shelves over the worktops.
void add_strips(const Site& room)
{
    const Site wall = room.at({0.0f, 0.0f, north});
    wall.box(Stuff::strip, {{-1.15f, 1.488f, 0.06f}, {-0.37f, 1.5f, 0.12f}, 0.002f});
    wall.box(Stuff::strip, {{1.0f, 1.455f, 0.04f}, {2.7f, 1.464f, 0.09f}, 0.002f});
    room.at({west, 0.0f, 0.0f}, 90.0f)
        .box(Stuff::strip, {{-1.1f, 1.455f, 0.04f}, {1.5f, 1.464f, 0.09f}, 0.002f});
}

} // namespace

void add_cabinets(const Site& room)
{
    add_north_row(room);
    add_east_row(room);
    add_west_row(room);
    add_shelf(room.at({0.0f, 0.0f, north}), {0.9f, 2.85f}, 1.50f);
    add_shelf(room.at({0.0f, 0.0f, north}), {0.9f, 2.85f}, 1.90f);
    add_strips(room);
}

} // namespace lambent::kitchen
