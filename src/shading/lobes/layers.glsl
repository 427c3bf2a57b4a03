// What lobes over the base have in common. Hook: that of albedo.glsl.

// Whether lobes may lie over a model's base. Witness: the list.
int takes_layers(int model)
{
    int takes = 0;
#define BASE(name, number, layered) \
    if (model == number)            \
        takes = layered;
#include "shading/passes/bases.h"
    return takes;
}

// The share of light that a lobe leaves to what lies below it, for a viewer who sees it with that albedo: all but what it sends on
// itself, of which `there` is there. [albedo scaling: OpenPBR 1.0] Witness: the white furnace.
vec3 left_below(Real there, Metallic facets, vec2 albedo)
{
    Reflectance r = reflectance_metallic(facets, albedo);
    return vec3(1.0) - there * (r.plain + r.grazing);
}

// The same at a point with that normal. Witness: as before.
vec3 left_below_at(Real there, Metallic facets, vec3 N, vec3 V)
{
    return left_below(there, facets, albedo_of(dot(N, V), facets.alpha.x));
}

#include "shading/lobes/layers.h"
