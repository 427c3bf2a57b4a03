// Lights without size as a point sees them, and blurred backgrounds.
#pragma once

#include "reference/sampler.h"
#include "scene/scene.h"

#include <glm/ext/vector_double3.hpp>

namespace lambent::reference {

struct LightArrival {
    glm::dvec3 direction{0.0};   ///< unit, towards the light
    glm::dvec3 illuminance{0.0}; ///< lux on a surface facing it
    double distance = 0.0;       ///< metres; infinite for directional lights
};
LightArrival arrival_of(const scene::Light& light, const glm::dvec3& point);

/// A direction near the given one, normally distributed with standard deviation roughness^2 radians along each axis:
/// what `--background blur` looks through.
glm::dvec3 blurred(const glm::dvec3& direction, double roughness, SampleSequence& sampler);

} // namespace lambent::reference
