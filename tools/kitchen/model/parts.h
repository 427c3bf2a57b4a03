// The parts of the kitchen. Each is added at a site: its foot, or its upper end if it hangs.
#pragma once

#include "kitchen/model/site.h"

namespace lambent::kitchen {

// Parts whose site is the whole room.
void add_room(const Site& room);     ///< floor, walls with openings, ceiling, baseboards, spots
void add_windows(const Site& room);  ///< frames, sill
void add_garden(const Site& room);   ///< outside
void add_cabinets(const Site& room); ///< along the walls, with worktops, shelves and tiles
void add_island(const Site& room);   ///< with stools and lamps
void add_things(const Site& room);   ///< small objects and plants
void add_dining(const Site& room);   ///< table, chairs, lamp, rug, pictures

// Parts along a wall or in a worktop: the site is on the wall (z = 0, +Z into the room) or on the worktop's surface.
void add_fridge(const Site& site);
void add_oven(const Site& site); ///< 0.56 m wide and 0.58 high, the lower middle of its front at the site
void add_hood(const Site& site);
void add_cooktop(const Site& site);
void add_sink(const Site& site);

void add_stool(const Site& site);
void add_chair(const Site& site);
void add_pendant(const Site& site, const glm::vec3& tint, float cord); ///< the site is the rim's centre

// Crockery, which stands on the site.
void add_plate(const Site& site, const glm::vec3& tint);
void add_bowl(const Site& site, const glm::vec3& tint);
void add_cup(const Site& site, const glm::vec3& tint);
void add_bottle(const Site& site, const glm::vec3& tint);
void add_jar(const Site& site, const glm::vec3& content);
void add_vase(const Site& site, const glm::vec3& tint);
void add_pot_with_lid(const Site& site);
void add_kettle(const Site& site);
void add_toaster(const Site& site);
void add_coffee_machine(const Site& site);
void add_utensils(const Site& site);
void add_knife_block(const Site& site);
void add_books(const Site& site, int count);

// Food and plants, which stand on the site.
void add_fruit_bowl(const Site& site);
void add_apple(const Site& site, const glm::vec3& tint);
void add_lemon(const Site& site);
void add_orange(const Site& site);
void add_herb(const Site& site);
void add_tall_plant(const Site& site);
void add_cutting_board(const Site& site);

void add_clock(const Site& wall); ///< on a wall

} // namespace lambent::kitchen
