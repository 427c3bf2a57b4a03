// Selection of the lights that can reach the points of a box.
#pragma once

#include "draw/light_context.h"
#include "scene/scene.h"

#include <span>
#include <vector>

namespace lambent::draw {

/// Fills `chosen` with all lights except those whose range ends before the box: there their light is exactly 0.
void choose_lights(std::span<const LightSource> lights, const scene::Bounds& box,
                   std::vector<LightSource>& chosen);

} // namespace lambent::draw
