// Ray marching through the atmosphere.
#pragma once

#include "environment/sky/atmosphere.h"

#include <cmath>

namespace lambent::environment {

/// Effective length of a step, in km: the integral over the step of the transmittance to its start. Extinction is
/// constant over the step, and `left` is its transmittance. [Hillaire 2015, "Physically based and unified volumetric
/// rendering in Frostbite", analytic integration]
inline Spectrum effective_length(const Spectrum& extinction, const Spectrum& left, float length)
{
    Spectrum result;
    for (int i = 0; i < band_count; ++i) {
        const float depth = extinction[i] * length;
        result[i] = depth < 1e-3f ? length * (1.0f - 0.5f * depth) : (1.0f - left[i]) / extinction[i];
    }
    return result;
}

/// Visits `steps` points of a ray, up to `length` km from its start: visit(distance, point, densities, weight), where
/// weight times the light scattered per km at the point is the light that arrives from the step at the ray's start.
/// Steps grow with distance. Returns the transmittance of the whole path; light not deflected counts as transmitted.
template <class Visit>
Spectrum march(const Atmosphere& atmosphere, const Ray& ray, double length, int steps, Visit&& visit)
{
    Spectrum passed = Spectrum::all(1.0f);
    for (int i = 0; i < steps; ++i) {
        const double t = (i + 0.5) / steps;
        const float step = static_cast<float>(2.0 * t * length / steps);
        const double distance = t * t * length;
        const Ray point = further_along(ray, distance);
        const Densities densities = atmosphere.densities(point.altitude);
        const Spectrum extinction = atmosphere.deflection(densities);
        const Spectrum left = transmitted(step * extinction);
        visit(distance, point, densities, passed * effective_length(extinction, left, step));
        passed *= left;
    }
    return passed;
}

/// Direction to the sun from the point of a ray `distance` km from its start. `towards_sun` is the direction from the
/// start, `between_cosine` the cosine of the angle between ray and sun.
inline Ray sun_from(const Ray& towards_sun, double between_cosine, double distance, double altitude)
{
    const double start = Atmosphere::ground_radius + towards_sun.altitude;
    const double there = Atmosphere::ground_radius + altitude;
    const double cosine = (start * towards_sun.cosine + distance * between_cosine) / there;
    return {altitude, cosine < -1.0 ? -1.0 : cosine > 1.0 ? 1.0 : cosine};
}

/// The share of sunlight that arrives at a point, undeflected.
inline Spectrum sunlight_at(const Atmosphere& atmosphere, const Ray& towards_sun)
{
    const double visible = visible_sun(towards_sun);
    if (visible <= 0.0)
        return {};
    return static_cast<float>(visible) * atmosphere.undeflected(towards_sun);
}

} // namespace lambent::environment
