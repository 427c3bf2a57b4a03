// The garden: a terrace, planters and trees, low enough for sky and sun to light the room.
#include "kitchen/model/parts.h"
#include "kitchen/model/plan.h"

#include <cmath>

namespace lambent::kitchen {
namespace {

using namespace plan;

constexpr float ground = -0.12f;

// Random leaves in a ball, denser towards its surface. The site is its centre.
struct Crown {
    glm::vec3 radii{1.0f};
    int leaves = 1000;
    float leaf = 0.12f; ///< metres
    glm::vec3 tint{0.15f, 0.25f, 0.07f};
};

void add_crown(const Site& site, const Crown& crown)
{
    for (int i = 0; i < crown.leaves; ++i) {
        const float y = 2.0f * site.chance() - 1.0f, turn = 360.0f * site.chance();
        const float flat = std::sqrt(1.0f - y * y), depth = std::sqrt(0.25f + 0.75f * site.chance());
        const float angle = 6.2831853f * site.chance();
        const glm::vec3 at =
            depth * crown.radii * glm::vec3(flat * std::cos(angle), y, flat * std::sin(angle));
        site.at(at, turn)
            .tipped(70.0f * (site.chance() - 0.5f))
            .add(Stuff::leaf, make_leaf({crown.leaf, 0.7f * crown.leaf, 0.6f, 2}),
                 (0.6f + 0.8f * site.chance()) * crown.tint);
    }
}

void add_tree(const Site& site, float height, const glm::vec3& tint)
{
    const glm::vec3 trunk[] = {
        {0.0f, ground, 0.0f}, {0.06f, 0.4f * height, 0.03f}, {0.0f, 0.85f * height, -0.04f}};
    site.tube(Stuff::wood, {smooth(trunk, 6), {0.09f}, 12}, {0.35f, 0.28f, 0.22f});
    const float r = 0.27f * height;
    add_crown(site.at({0.0f, 0.68f * height, 0.0f}), {{r, 0.9f * r, r}, 900, 0.17f, tint});
    add_crown(site.at({0.5f * r, 0.88f * height, 0.3f * r}),
              {{0.7f * r, 0.6f * r, 0.7f * r}, 450, 0.17f, tint});
    add_crown(site.at({-0.6f * r, 0.58f * height, -0.4f * r}),
              {{0.6f * r, 0.5f * r, 0.6f * r}, 350, 0.17f, tint});
}

// A long box with bushes in it, along X.
void add_planter(const Site& site, float length)
{
    site.box(Stuff::stone, {{0.0f, ground, -0.2f}, {length, 0.28f, 0.2f}, 0.02f, 2, 0});
    for (float x = 0.25f; x < length; x += 0.42f)
        add_crown(site.at({x, 0.42f, 0.0f}), {{0.27f, 0.2f, 0.22f}, 130, 0.07f, {0.17f, 0.27f, 0.08f}});
}

void add_terrace(const Site& room)
{
    constexpr float width = 0.14f, end = south + 3.4f;
    for (float x = -2.0f; x < 4.0f; x += width)
        room.box(Stuff::wood,
                 {{x + 0.003f, ground, south + wall}, {x + width - 0.003f, -0.03f, end}, 0.004f, 1, 2},
                 (0.85f + 0.2f * room.chance()) * pale_oak);
}

} // namespace

void add_garden(const Site& room)
{
    // A lawn as large as is visible over the sills.
    room.box(Stuff::cloth, {{-30.0f, ground - 0.2f, -30.0f}, {30.0f, ground, 30.0f}}, {0.13f, 0.19f, 0.05f});
    add_terrace(room);
    add_planter(room.at({-2.0f, 0.0f, south + 3.2f}), 6.0f);
    // Trees beside the direction of the sun.
    const glm::vec3 green(0.16f, 0.25f, 0.07f), olive(0.20f, 0.25f, 0.12f);
    add_tree(room.at({8.6f, 0.0f, -8.3f}), 4.6f, green);
    add_tree(room.at({10.5f, 0.0f, -3.4f}, 70.0f), 3.4f, olive);
    add_tree(room.at({-1.6f, 0.0f, 8.2f}, 140.0f), 4.4f, green);
    add_tree(room.at({2.2f, 0.0f, 11.5f}, 200.0f), 3.6f, olive);
}

} // namespace lambent::kitchen
