// The floor plan. Metres; north is -Z, east +X.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace lambent::kitchen::plan {

constexpr float west = -2.8f, east = 2.9f, north = -3.3f, south = 2.3f;
constexpr float ceiling = 2.7f;
constexpr float wall = 0.3f; ///< thickness

constexpr float counter_top = 0.92f, counter_depth = 0.62f, slab = 0.04f;
constexpr float sink = -0.85f;   ///< position along the east wall
constexpr float cooktop = 0.25f; ///< position along the north wall
constexpr float cabinet_top = 2.35f;

/// The top of the island.
constexpr glm::vec2 island_low(-1.05f, -1.9f), island_high(1.4f, -0.98f);

/// An opening in a wall, in the axes of a site at the middle of the wall's foot: from low to high, divided into `panes`
/// side by side.
struct Opening {
    glm::vec2 low, high;
    int panes;
};
constexpr Opening window{{-2.35f, 1.08f}, {0.75f, 2.5f}, 4};
constexpr Opening patio_door{{-2.3f, 0.0f}, {0.1f, 2.35f}, 2};

/// The centres of all panes, in the axes of the room.
std::vector<glm::vec3> pane_middles();

// Tints that several parts share.
constexpr glm::vec3 oak(0.74f, 0.50f, 0.30f), pale_oak(0.80f, 0.68f, 0.53f), walnut(0.40f, 0.24f, 0.14f);
constexpr glm::vec3 white(0.98f, 0.97f, 0.95f), sage(0.50f, 0.58f, 0.48f);

} // namespace lambent::kitchen::plan
