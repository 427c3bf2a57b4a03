// Walking along a ray through the atmosphere.
#pragma once

#include "environment/sky/atmosphere.h"

#include <cmath>

namespace lambent::environment {

/// How long a step acts, in km: the integral over the step of what is left of light scattered there on its way to the
/// step's start. Extinction is constant over the step. [Hillaire 2015, "Physically based and unified volumetric rendering
/// in Frostbite", analytic integration]
inline Spectrum effective_length(const Spectrum& extinction, const Spectrum& left, float length)
{
    Spectrum result;
    for (int i = 0; i < band_count; ++i) {
        const float depth = extinction[i] * length;
        result[i] = depth < 1e-3f ? length * (1.0f - 0.5f * depth) : (1.0f - left[i]) / extinction[i];
    }
    return result;
}

/// Visits `steps` points of a ray, up to `length` km from its start: visit(distance, point, densities, weight), where the
/// light that the step sends to the ray's start is weight times what it scatters per km. Steps grow with distance.
/// Returns the share of light that passes the whole way. Light that is not deflected counts as passing.
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

/// Direction to the sun, seen from a point of a ray `distance` from its start: towards_sun is that at the start, and
/// between_cosine that of the angle between ray and sun.
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
