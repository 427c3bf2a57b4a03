#include "draw/cpu/light_choice.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lambent::draw {

void choose_lights(std::span<const LightSource> lights, const scene::Bounds& box,
                   std::vector<LightSource>& chosen)
{
    constexpr float rounding = 1.0001f;
    chosen.clear();
    for (const LightSource& light : lights) {
        const glm::vec3 way = light.position - glm::clamp(light.position, box.low, box.high);
        // An infinite range reaches everything: the comparison is false.
        if (!light.local || !(glm::dot(way, way) > rounding * light.range * light.range))
            chosen.push_back(light);
    }
}

} // namespace lambent::draw
