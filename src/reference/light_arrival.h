// Light of sources without size as it arrives at a point, and blurred backgrounds.
#pragma once

#include "reference/samples/sampler.h"
#include "scene/scene.h"

#include <glm/ext/vector_double3.hpp>

namespace lambent::reference {

struct LightArrival {
    glm::dvec3 direction{0.0};   ///< unit, towards the light
    glm::dvec3 illuminance{0.0}; ///< lux on a surface facing it
    double distance = 0.0;       ///< metres; infinite for directional lights
};
LightArrival arrival_of(const scene::Light& light, const glm::dvec3& point);

/// A random direction near the given one, normally distributed with standard deviation roughness^2 radians along each
/// axis, as `--background blur:ROUGHNESS` blurs.
glm::dvec3 blurred(const glm::dvec3& direction, double roughness, SampleSequence& sampler);

} // namespace lambent::reference
