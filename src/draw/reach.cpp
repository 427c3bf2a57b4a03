#include "draw/reach.h"

#include "trace/visibility.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace lambent::draw {

bool within_reach(const RayMap& map)
{
    constexpr float widest = 65536.0f; // the largest picture, pixels
    const auto all_within = [](const glm::vec3& start, const glm::vec3& dx, const glm::vec3& dy) {
        const glm::vec3 most = glm::abs(start) + widest * (glm::abs(dx) + glm::abs(dy));
        // False for NaN.
        return glm::all(glm::lessThanEqual(most, glm::vec3(trace::Visibility::furthest)));
    };
    return all_within(map.origin, map.origin_dx, map.origin_dy) &&
           all_within(map.direction, map.direction_dx, map.direction_dy);
}

} // namespace lambent::draw
