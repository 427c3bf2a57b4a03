// The classes of light that are found and filtered apart.
#pragma once

#include <cstddef>

namespace lambent::draw {

/// What a surface reflects diffusely, and what it reflects by its glossy lobes.
enum LightClass : std::size_t { diffuse_light, glossy_light, light_classes };

} // namespace lambent::draw
