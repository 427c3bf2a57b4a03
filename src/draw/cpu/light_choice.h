// Which lights can matter to the points of a box.
#pragma once

#include "draw/light_context.h"
#include "scene/scene.h"

#include <span>
#include <vector>

namespace lambent::draw {

/// Fills `chosen` with all lights but those whose range ends before the box, whose light there is exactly 0.
void choose_lights(std::span<const LightSource> lights, const scene::Bounds& box,
                   std::vector<LightSource>& chosen);

} // namespace lambent::draw
