// Floor, walls and ceiling.
#include "kitchen/model/parts.h"
#include "kitchen/model/plan.h"

#include <algorithm>

namespace lambent::kitchen {
namespace {

using namespace plan;

const glm::vec3 warm_white(1.0f, 0.975f, 0.93f);

// Planks of different lengths along Z, with joints between them.
void add_floor(const Site& room)
{
    room.box(Stuff::black, {{west - wall, -0.3f, north - wall}, {east + wall, -0.015f, south + wall}});
    constexpr float width = 0.19f, joint = 0.0015f;
    for (float x = west; x < east; x += width) {
        float z = north - 1.8f * room.chance();
        while (z < south) {
            const float end = z + 1.5f + 0.6f * room.chance();
            const float shade = 0.82f + 0.26f * room.chance();
            BoxShape plank{{x + joint, -0.02f, std::max(z, north) + joint},
                           {std::min(x + width, east) - joint, 0.0f, std::min(end, south) - joint}};
            plank.bevel = 0.002f;
            plank.grain = 2;
            if (plank.high.z - plank.low.z > 0.02f && plank.high.x - plank.low.x > 0.02f)
                room.box(Stuff::wood, plank, shade * pale_oak);
            z = end;
        }
    }
}

// A wall: one box without openings, or boxes around an opening. The site is at the middle of the wall's foot.
void add_wall(const Site& site, const glm::vec2& ends, const plan::Opening* opening, const glm::vec3& tint)
{
    const auto piece = [&](const glm::vec2& low, const glm::vec2& high) {
        if (high.y > low.y)
            site.box(Stuff::plaster, {{low.x, low.y, -wall}, {high.x, high.y, 0.0f}}, tint);
    };
    if (!opening) {
        piece({ends.x, -0.1f}, {ends.y, ceiling + 0.1f});
        return;
    }
    piece({ends.x, -0.1f}, {opening->low.x, ceiling + 0.1f});
    piece({opening->high.x, -0.1f}, {ends.y, ceiling + 0.1f});
    piece({opening->low.x, -0.1f}, {opening->high.x, opening->low.y});
    piece({opening->low.x, opening->high.y}, {opening->high.x, ceiling + 0.1f});
}

void add_baseboard(const Site& site, float from, float to)
{
    BoxShape board{{from, 0.0f, 0.0f}, {to, 0.09f, 0.014f}, 0.004f};
    site.box(Stuff::lacquer, board, white);
}

// Lamps recessed into the ceiling.
void add_spots(const Site& room)
{
    for (const float x : {-1.9f, -0.55f, 0.8f, 2.1f})
        for (const float z : {-2.45f, 0.0f, 1.4f}) {
            const Site spot = room.at({x, ceiling, z});
            spot.lathe(
                Stuff::lacquer,
                {{{0.0f, -0.004f}, {0.055f, -0.004f}, {0.06f, -0.006f}, {0.07f, -0.006f}, {0.074f, 0.0f}},
                 32},
                white);
            spot.lathe(Stuff::spot, {{{0.0f, -0.008f}, {0.05f, -0.008f}, {0.052f, -0.003f}}, 32});
        }
}

} // namespace

void add_room(const Site& room)
{
    add_floor(room);
    room.box(Stuff::plaster,
             {{west - wall, ceiling, north - wall}, {east + wall, ceiling + wall, south + wall}}, white);
    // Both walls extend to the outer corner where they meet.
    const glm::vec2 across(west - wall, east + wall);
    add_wall(room.at({0.0f, 0.0f, north}), across, nullptr, warm_white);
    add_wall(room.at({0.0f, 0.0f, south}, 180.0f), across, &patio_door, warm_white);
    add_wall(room.at({east, 0.0f, 0.0f}, -90.0f), {north - wall, south + wall}, &plan::window, warm_white);
    add_wall(room.at({west, 0.0f, 0.0f}, 90.0f), {-south - wall, -north + wall}, nullptr, sage);
    add_baseboard(room.at({0.0f, 0.0f, south}, 180.0f), -east, patio_door.low.x - 0.08f);
    add_baseboard(room.at({0.0f, 0.0f, south}, 180.0f), patio_door.high.x + 0.08f, east);
    add_baseboard(room.at({west, 0.0f, 0.0f}, 90.0f), -south, -1.25f);
    add_baseboard(room.at({east, 0.0f, 0.0f}, -90.0f), 0.95f, south);
    add_spots(room);
}

} // namespace lambent::kitchen
