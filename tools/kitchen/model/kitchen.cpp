#include "kitchen/model/kitchen.h"

#include "kitchen/model/parts.h"
#include "kitchen/model/site.h"

namespace lambent::kitchen {

scene::Scene make_kitchen()
{
    Work work;
    const Site room(work);
    add_room(room);
    add_windows(room);
    add_garden(room);
    add_cabinets(room);
    add_island(room);
    add_dining(room);
    add_things(room);
    return std::move(work.scene);
}

glm::vec3 kitchen_viewpoint()
{
    return {0.2f, 1.45f, -0.1f};
}

} // namespace lambent::kitchen
