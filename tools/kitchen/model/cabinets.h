// Cabinets: boxes with fronts, gaps between the fronts, and handles.
#pragma once

#include "kitchen/model/site.h"

namespace lambent::kitchen {

enum class Fronts { doors, drawers, tall_doors };

/// A cabinet in the axes of a wall's site: +Z into the room.
struct Cabinet {
    glm::vec2 low, high; ///< along the wall and upwards
    float depth = 0.6f;  ///< including fronts
    int columns = 1;
    Fronts fronts = Fronts::doors;
    Stuff stuff = Stuff::wood;
    glm::vec3 tint{1.0f};
    bool handles_low = false; ///< at the lower ends of the doors, for wall cabinets
};
void add_cabinet(const Site& wall, const Cabinet& cabinet);

/// One front from low to high, its back at z.
struct Front {
    glm::vec2 low, high;
    float z;
    Stuff stuff = Stuff::wood;
    glm::vec3 tint{1.0f};
};
void add_front(const Site& wall, const Front& front);

/// A bar handle from `from` to `to`, in front of the plane z = from.z.
void add_handle(const Site& wall, const glm::vec3& from, const glm::vec3& to);

} // namespace lambent::kitchen
