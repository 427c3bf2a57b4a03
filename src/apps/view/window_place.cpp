#include "apps/view/window_place.h"

#include <algorithm>
#include <cstdint>

namespace lambent::view_window {
namespace {

// So much of the top edge must be visible, and so much height below it.
constexpr std::int64_t least_across = 100, least_down = 50;

bool can_be_held(const WindowPlace& place, const WorkArea& area)
{
    const std::int64_t left = std::max<std::int64_t>(place.corner->x, area.x);
    const std::int64_t right =
        std::min(std::int64_t{place.corner->x} + place.width, std::int64_t{area.x} + area.width);
    const std::int64_t down = std::int64_t{area.y} + area.height - place.corner->y;
    return right - left >= least_across && place.corner->y >= area.y && down >= least_down;
}

} // namespace

WindowPlace reachable(WindowPlace place, const std::vector<WorkArea>& areas)
{
    if (areas.empty())
        return place;
    const auto largest =
        std::max_element(areas.begin(), areas.end(), [](const WorkArea& a, const WorkArea& b) {
            return std::int64_t{a.width} * a.height < std::int64_t{b.width} * b.height;
        });
    if (largest->width > 0 && largest->height > 0) {
        place.width = std::min(place.width, largest->width);
        place.height = std::min(place.height, largest->height);
    }
    if (place.corner && std::none_of(areas.begin(), areas.end(),
                                     [&](const WorkArea& area) { return can_be_held(place, area); }))
        place.corner.reset();
    return place;
}

} // namespace lambent::view_window
