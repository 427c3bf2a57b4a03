// Surfaces that block a ray, by their sides and their alpha.
#pragma once

#include "reference/path.h"

namespace lambent::reference {

/// The kind of a ray. Camera rays pass through the backs of one-sided surfaces, by glTF's culling; light does not.
enum class RayOf { camera, light };

/// The first surface that blocks the ray. Surfaces that are not opaque block it at random, with probability alpha.
/// Camera rays ignore culled backs.
trace::Hit first_obstacle(const World& world, trace::Ray ray, RayOf whose, SampleSequence& sampler);

/// Share of the light that passes along a ray, 0 to 1. Both sides of every surface block light, by its alpha.
double passing(const World& world, trace::Ray ray);

} // namespace lambent::reference
