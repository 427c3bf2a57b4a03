// Lobes over the base at a fragment. Hooks: see README.md.

// A lobe over the base: its strength, 0 to 1, its surface point, its facets and their albedo, and the share of light
// that it leaves to the lobes below.
struct Layer {
    Real there;
    ShinyPoint shiny;
    Metallic facets;
    vec2 albedo;
    vec3 left;
};

Layer layer_at(Fragment f, Real there, Metallic facets, int number)
{
    ShinyPoint s = load_shine(f, number);
    vec2 albedo = albedo_of(dot(s.normal, s.view), facets.alpha.x);
    Layer layer = {there, s, facets, albedo, left_below(there, facets, albedo)};
    return layer;
}

// The lobe, or a lobe without effect if its strength is 0 in all lanes.
Layer layer_or_none(Fragment f, Real there, Metallic facets, int number)
{
    Layer layer = {there, load_shine(f, 0), facets, vec2(0.0), vec3(1.0)};
    if (has_layers() != 0 && any_of(there > 0.0))
        layer = layer_at(f, there, facets, number);
    return layer;
}

// The light that the lobes over the base let through.
vec3 through_layers(Environment e, Fragment f, Material m, vec3 light)
{
    vec3 left = light;
#define LAYER(name, number, texture)               \
    if (has_layers() != 0 && any_of(m.name > 0.0)) \
        left = layer_at(f, m.name, facets_##name(m, compensation_of(e)), number).left * left;
#include "shading/lobes/layers.h"
    return left;
}
