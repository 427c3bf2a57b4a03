// Positions of the small objects and plants.
#include "kitchen/model/parts.h"
#include "kitchen/model/plan.h"

namespace lambent::kitchen {
namespace {

using namespace plan;

const glm::vec3 blue(0.22f, 0.36f, 0.46f), cream(0.90f, 0.86f, 0.76f), clay(0.62f, 0.32f, 0.20f),
    mint(0.55f, 0.70f, 0.62f);
const glm::vec3 oil(0.36f, 0.34f, 0.06f), wine(0.06f, 0.10f, 0.05f), pasta(0.85f, 0.62f, 0.28f),
    coffee(0.16f, 0.08f, 0.04f);
const glm::vec3 lentils(0.58f, 0.26f, 0.10f), rice(0.86f, 0.82f, 0.72f), beans(0.36f, 0.09f, 0.07f);

void add_stack(const Site& site, int count, const glm::vec3& tint)
{
    for (int i = 0; i < count; ++i)
        add_plate(site.at({0.0f, 0.011f * static_cast<float>(i), 0.0f}), tint);
}

void add_bowls(const Site& site, int count, const glm::vec3& tint)
{
    for (int i = 0; i < count; ++i)
        add_bowl(site.at({0.0f, 0.024f * static_cast<float>(i), 0.0f}), tint);
}

void add_row_of_cups(const Site& site, int count, const glm::vec3& tint)
{
    for (int i = 0; i < count; ++i)
        add_cup(site.at({0.12f * static_cast<float>(i), 0.0f, 0.0f}, 40.0f + 30.0f * site.chance()), tint);
}

void add_row_of_jars(const Site& site)
{
    const glm::vec3 contents[] = {pasta, coffee, rice, lentils, beans};
    for (int i = 0; i < 5; ++i)
        add_jar(site.at({0.125f * static_cast<float>(i), 0.0f, 0.0f}), contents[i]);
}

// Plates on edge, displayed against the wall.
void add_shown_plate(const Site& shelf, float x, const glm::vec3& tint)
{
    add_plate(shelf.at({x, 0.132f, 0.035f}).tipped(82.0f), tint);
}

void add_on_north(const Site& room)
{
    const Site low = room.at({0.0f, 1.50f, north + 0.14f}), high = room.at({0.0f, 1.90f, north + 0.14f});
    add_stack(low.at({1.08f, 0.0f, 0.0f}), 7, white);
    add_bowls(low.at({1.34f, 0.0f, 0.0f}), 4, blue);
    add_row_of_cups(low.at({1.52f, 0.0f, 0.0f}), 4, cream);
    add_row_of_jars(low.at({2.1f, 0.0f, 0.0f}));
    add_bowls(high.at({1.05f, 0.0f, 0.0f}), 3, cream);
    add_shown_plate(high.at({0.0f, 0.0f, -0.14f}), 1.33f, blue);
    add_shown_plate(high.at({0.0f, 0.0f, -0.14f}), 1.62f, cream);
    add_bottle(high.at({1.9f, 0.0f, 0.0f}), oil);
    add_bottle(high.at({2.0f, 0.0f, 0.02f}), wine);
    add_herb(high.at({2.2f, 0.0f, 0.0f}).scaled(1.2f));
    add_books(high.at({2.38f, 0.0f, -0.1f}), 9);
    const Site top = room.at({0.0f, counter_top, north});
    add_pot_with_lid(top.at({cooktop + 0.22f, 0.007f, 0.20f}, 30.0f));
    add_kettle(top.at({cooktop - 0.22f, 0.007f, 0.42f}, 200.0f));
    add_utensils(top.at({0.84f, 0.0f, 0.2f}));
    add_bottle(top.at({0.98f, 0.0f, 0.16f}), oil);
    add_knife_block(top.at({-0.45f, 0.0f, 0.2f}));
    add_row_of_jars(top.at({1.3f, 0.0f, 0.15f}));
    add_toaster(top.at({-0.95f, 0.0f, 0.25f}, 10.0f));
    // Boards leaning against the wall.
    top.at({2.15f, 0.0f, 0.09f})
        .tipped(-9.0f)
        .box(Stuff::wood, {{-0.15f, 0.003f, 0.0f}, {0.15f, 0.42f, 0.02f}, 0.008f, 2}, walnut);
    top.at({2.3f, 0.0f, 0.13f})
        .tipped(-9.0f)
        .box(Stuff::wood, {{-0.12f, 0.003f, 0.0f}, {0.12f, 0.32f, 0.018f}, 0.008f, 2}, pale_oak);
}

void add_on_east(const Site& room)
{
    const Site wall = room.at({east, counter_top, 0.0f}, -90.0f);
    const Site sill = room.at({east, plan::window.low.y + 0.022f, 0.0f}, -90.0f);
    add_herb(sill.at({-2.12f, 0.0f, -0.03f}));
    add_herb(sill.at({-1.95f, 0.0f, -0.04f}));
    add_herb(sill.at({0.58f, 0.0f, -0.03f}).scaled(1.1f));
    add_bottle(wall.at({sink + 0.5f, 0.0f, 0.1f}).scaled(0.7f), {0.75f, 0.55f, 0.30f});
    add_stack(wall.at({0.15f, 0.0f, 0.3f}), 5, white);
    add_bowls(wall.at({0.15f, 0.055f, 0.3f}), 2, mint);
    add_row_of_cups(wall.at({0.36f, 0.0f, 0.25f}), 3, mint);
    add_coffee_machine(wall.at({-1.9f, 0.0f, 0.26f}, 20.0f));
    add_vase(wall.at({0.8f, 0.0f, 0.2f}).scaled(0.8f), clay);
    // A towel over the front of the sink.
    wall.box(Stuff::cloth,
             {{sink - 0.14f, -0.36f, counter_depth - 0.004f},
              {sink + 0.10f, 0.006f, counter_depth + 0.008f},
              0.004f,
              2},
             cream);
    wall.box(Stuff::cloth,
             {{sink - 0.141f, -0.32f, counter_depth - 0.0035f},
              {sink + 0.101f, -0.28f, counter_depth + 0.009f},
              0.004f,
              2},
             blue);
}

void add_on_west(const Site& room)
{
    const Site wall = room.at({west, 0.0f, 0.0f}, 90.0f);
    const Site top = wall.at({0.0f, counter_top, 0.0f}), low = wall.at({0.0f, 1.50f, 0.14f}),
               high = wall.at({0.0f, 1.90f, 0.14f});
    add_stack(low.at({-1.0f, 0.0f, 0.0f}), 8, cream);
    add_bowls(low.at({-0.72f, 0.0f, 0.0f}), 5, mint);
    add_bowls(low.at({-0.52f, 0.0f, 0.0f}), 3, clay);
    add_row_of_cups(low.at({-0.3f, 0.0f, 0.0f}), 5, blue);
    add_row_of_jars(low.at({0.45f, 0.0f, 0.0f}));
    add_herb(low.at({1.2f, 0.0f, 0.0f}).scaled(1.3f));
    add_books(high.at({-1.1f, 0.0f, -0.1f}), 12);
    add_shown_plate(high.at({0.0f, 0.0f, -0.14f}), -0.45f, white);
    add_shown_plate(high.at({0.0f, 0.0f, -0.14f}), -0.15f, clay);
    add_shown_plate(high.at({0.0f, 0.0f, -0.14f}), 0.15f, white);
    add_bottle(high.at({0.5f, 0.0f, 0.0f}), wine);
    add_bottle(high.at({0.61f, 0.0f, -0.02f}), wine);
    add_bottle(high.at({0.72f, 0.0f, 0.01f}), oil);
    add_vase(high.at({1.05f, 0.0f, 0.0f}).scaled(0.7f), blue);
    add_bottle(top.at({1.3f, 0.0f, 0.2f}), wine);
    add_bottle(top.at({1.42f, 0.0f, 0.17f}), oil);
    // A bread bin, and a bowl of lemons.
    top.box(Stuff::lacquer, {{-0.85f, 0.0f, 0.12f}, {-0.42f, 0.22f, 0.40f}, 0.06f, 5}, mint);
    top.box(Stuff::wood, {{-0.86f, 0.215f, 0.11f}, {-0.41f, 0.24f, 0.41f}, 0.01f, 2, 0}, pale_oak);
    add_bowls(top.at({0.2f, 0.0f, 0.3f}).scaled(1.5f), 1, white);
    add_lemon(top.at({0.22f, 0.045f, 0.31f}, 20.0f));
    add_lemon(top.at({0.17f, 0.05f, 0.28f}, 80.0f));
    add_lemon(top.at({0.2f, 0.085f, 0.3f}, 140.0f));
    add_row_of_cups(top.at({0.6f, 0.0f, 0.25f}), 3, clay);
    add_clock(wall.at({2.1f, 1.85f, 0.0f}));
}

} // namespace

void add_things(const Site& room)
{
    add_on_north(room);
    add_on_east(room);
    add_on_west(room);
    const Site island = room.at({0.0f, counter_top, 0.0f});
    add_fruit_bowl(island.at({0.1f, 0.0f, -1.35f}, 20.0f));
    add_cutting_board(island.at({0.85f, 0.0f, -1.4f}, -12.0f));
    add_vase(island.at({-0.72f, 0.0f, -1.5f}, 30.0f), cream);
    add_stack(island.at({-0.35f, 0.0f, -1.65f}), 3, white);
    add_tall_plant(room.at({-2.35f, 0.0f, 1.85f}));
    add_tall_plant(room.at({-0.42f, 0.0f, 2.0f}).scaled(0.75f));
}

} // namespace lambent::kitchen
