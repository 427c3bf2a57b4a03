// What is in the way of a ray: surfaces, by their sides and their alpha.
#pragma once

#include "reference/path.h"

namespace lambent::reference {

/// Who sends a ray: a camera looks through the backs of one-sided surfaces, as culling does; light meets them.
enum class RayOf { camera, light };

/// The first surface that is there for this ray: not the part that alpha lets through, and for a camera no culled back.
trace::Hit first_obstacle(const World& world, trace::Ray ray, RayOf whose, SampleSequence& sampler);

/// Share of the light that gets along a ray, 0 to 1. Both sides of every surface are in its way.
double passing(const World& world, trace::Ray ray);

} // namespace lambent::reference
