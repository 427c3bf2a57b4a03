// Code common to all lobes over the base. Hook: that of albedo.glsl.

// The share of light that a lobe leaves to the lobes below, for the view to which `albedo` belongs: one minus its own
// reflectance times its strength `there`, 0 to 1. [albedo scaling: OpenPBR 1.0]
// Witness: the white furnace (tests/draw).
vec3 left_below(Real there, Metallic facets, vec2 albedo)
{
    Reflectance r = reflectance_metallic(facets, albedo);
    return vec3(1.0) - there * (r.plain + r.grazing);
}

// The same at a point with normal N, for the view V. Witness: the white furnace (tests/draw).
vec3 left_below_at(Real there, Metallic facets, vec3 N, vec3 V)
{
    return left_below(there, facets, albedo_of(dot(N, V), facets.alpha.x));
}

#include "shading/lobes/layers.h"
