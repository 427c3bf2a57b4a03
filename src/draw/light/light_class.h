// The classes of light that are found and filtered apart.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>

namespace lambent::draw {

/// What a surface reflects diffusely, and what it reflects by its glossy lobes.
enum LightClass : std::size_t { diffuse_light, glossy_light, light_classes };

/// What the rays of one fragment found.
struct RayLight {
    /// The environment's light as if nothing were in its way, and as it is, with the light of what stops rays.
    std::array<glm::vec3, light_classes> unshadowed{}, found{};
    /// The same of the scene's lights, which have no size.
    glm::vec3 lights_unshadowed{0.0f}, lights_found{0.0f};
};

} // namespace lambent::draw
