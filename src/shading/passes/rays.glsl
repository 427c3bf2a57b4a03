// Rays from fragments that ask what light arrives: one along a direction of a lobe, one to a lamp. The light of either is
// given in two parts, what the surface reflects diffusely and what it reflects by its glossy lobes, because they look
// alike over different neighbourhoods. Hooks: see README.md.

// Light that a fragment reflects to the viewer, in its two parts.
struct TwoParts {
    vec3 diffuse;
    vec3 glossy;
};

// A fragment that rays leave, and the chances by which the lobe of a ray is drawn; their sum is 1.
struct RayOrigin {
    Receiver receiver;
    Real diffuse;
    Real base;
#define LAYER(name, number, texture) Real name;
#include "shading/lobes/layers.h"
};

// Luminance that the base reflects diffusely and by its lobe.
vec2 parts_of(Environment e, Receiver r)
{
    vec2 parts = vec2(0.0);
#define BASE(name, number, layered)     \
    if (model_of(e) == number)          \
        parts = parts_of_base(r.name);
#include "shading/passes/bases.h"
    return parts;
}

// Each lobe's chance is its share of what all reflect of white light from everywhere. The diffuse lobe and the base's have
// at least a twentieth each where they reflect anything, because light is not white.
RayOrigin ray_origin(Environment e, Fragment f)
{
    Receiver r = receiver_at(e, f);
    vec2 parts = parts_of(e, r);
    Real all = max(parts.x + parts.y, 1.0e-6);
    Real diffuse = select(parts.x > 0.0, clamp(parts.x / all, 0.05, 0.95), 0.0);
    RayOrigin o = {
        r,
        diffuse,
        1.0 - diffuse,
#define LAYER(name, number, texture) 0.0,
#include "shading/lobes/layers.h"
    };
    Real left = all;
    if (takes_layers(model_of(e)) != 0) {
#define LAYER(name, number, texture)                                                        \
    if (has_layers() != 0 && any_of(r.name.there > 0.0)) {                                  \
        Real through = luminance_of(r.name.left);                                           \
        o.name = (1.0 - through) / max(1.0 - through + through * left, 1.0e-6);             \
        left = 1.0 - through + through * left;                                              \
    }
#include "shading/lobes/layers.h"
    }
    return o;
}

// The density per solid angle of directions that drawn_ray draws.
ONE_BODY Real density_of_rays(Environment e, RayOrigin o, vec3 L)
{
    Real density = o.diffuse * density_by_cosine(o.receiver.shiny.normal, L);
#define BASE(name, number, layered)                                                               \
    if (model_of(e) == number)                                                                    \
        density += o.base * density_by_base(o.receiver.name, o.receiver.shiny, L);
#include "shading/passes/bases.h"
    if (takes_layers(model_of(e)) != 0) {
#define LAYER(name, number, texture)                                                                        \
    if (has_layers() != 0 && any_of(o.name > 0.0))                                                          \
        density = o.name * density_by_facets(o.receiver.name.facets, o.receiver.name.shiny, L) +            \
                  (1.0 - o.name) * density;
#include "shading/lobes/layers.h"
    }
    return density;
}

// A direction drawn from the lobes. pick chooses the lobe, point the direction in it.
vec3 drawn_ray(Environment e, RayOrigin o, Real pick, vec3 point)
{
    Real rest = pick;
    vec3 layer = vec3(0.0);
    Mask chosen = rest < 0.0;
    if (takes_layers(model_of(e)) != 0) {
#define LAYER(name, number, texture)                                                                        \
    if (has_layers() != 0 && any_of(o.name > 0.0)) {                                                        \
        Mask here = rest < o.name;                                                                          \
        layer = select(here, drawn_by_facets(o.receiver.name.facets, o.receiver.name.shiny, point), layer); \
        chosen = chosen || here;                                                                            \
        rest = select(here, rest, (rest - o.name) / max(1.0 - o.name, 1.0e-6));                             \
    }
#include "shading/lobes/layers.h"
    }
    vec3 glossy = vec3(0.0);
#define BASE(name, number, layered)                                             \
    if (model_of(e) == number)                                                  \
        glossy = drawn_by_base(o.receiver.name, o.receiver.shiny, point);
#include "shading/passes/bases.h"
    vec3 base = select(rest < o.diffuse, drawn_by_cosine(o.receiver.shiny.normal, point), glossy);
    return select(chosen, layer, base);
}

// Arriving light that the fragment reflects to the viewer, in its two parts.
ONE_BODY TwoParts reflected_parts(Environment e, Receiver r, Arrival a)
{
    vec3 all = direct_light(e, r, a);
    vec3 irradiance = max(dot(r.shiny.normal, a.direction), 0.0) * a.illuminance;
    vec3 diffuse = vec3(0.0);
#define BASE(name, number, layered)                               \
    if (model_of(e) == number)                                    \
        diffuse = ambient_base(e, r.name, irradiance, 1.0);
#include "shading/passes/bases.h"
    if (takes_layers(model_of(e)) != 0) {
#define LAYER(name, number, texture)                     \
    if (has_layers() != 0 && any_of(r.name.there > 0.0)) \
        diffuse = r.name.left * diffuse;
#include "shading/lobes/layers.h"
    }
    TwoParts parts = {diffuse, max(all - diffuse, vec3(0.0))};
    return parts;
}

// A ray along a direction of a lobe: what of its radiance reaches the viewer, and the radiance of the environment there,
// read through a blur as wide as the part of the sphere that the ray stands for. density 0: there is no ray.
struct LobeRay {
    vec3 direction;
    TwoParts share;
    Real density;
    vec3 radiance;
};

// The ray without the environment's radiance.
ONE_BODY LobeRay dark_lobe_ray(Environment e, RayOrigin o, vec3 direction)
{
    Real density = density_of_rays(e, o, direction);
    Mask there = density > 1.0e-6;
    Arrival one = {direction, vec3(select(there, 1.0 / max(density, 1.0e-6), 0.0))};
    LobeRay ray = {direction, reflected_parts(e, o.receiver, one), select(there, density, 0.0), vec3(0.0)};
    return ray;
}

// rays: how many like this one are drawn at about this place.
LobeRay lobe_ray(Environment e, RayOrigin o, vec3 direction, Real rays)
{
    LobeRay ray = dark_lobe_ray(e, o, direction);
    Real level = level_of_variance(variance_of_ray(ray.density, rays) / level_one_variance(e));
    LightSum sum = with_light(e, no_light(e), turned(e, direction), level, vec2(1.0, 0.0));
    ray.radiance = first_light(e, sum);
    return ray;
}

// A ray to one of several sources without size, chosen by the luminance that each would send on: its direction, its
// length, and the light over the chance of the choice.
struct LampRay {
    vec3 direction;
    Real distance;
    TwoParts light;
    Real total; // luminance of all sources so far
    Real pick;
};

LampRay no_lamp_ray(Real pick)
{
    LampRay ray = {vec3(0.0, 1.0, 0.0), 0.0, {vec3(0.0), vec3(0.0)}, 0.0, pick};
    return ray;
}

// The choice among the sources so far and one more, by one random number. [reservoir sampling: Chao 1982]
// Witness: frequencies of the choices, and what they bring (tests/draw).
LampRay or_lamp(LampRay ray, vec3 direction, Real distance, TwoParts light)
{
    Real size = luminance_of(light.diffuse + light.glossy);
    Real total = ray.total + size;
    Real chance = size / max(total, 1.0e-30);
    Mask takes = ray.pick < chance;
    Real pick = select(takes, ray.pick / max(chance, 1.0e-30), (ray.pick - chance) / max(1.0 - chance, 1.0e-6));
    // The light of the chosen source over its own luminance; chosen_light multiplies it by the sum of all.
    Real over = 1.0 / max(size, 1.0e-30);
    LampRay next = {select(takes, direction, ray.direction),
                    select(takes, distance, ray.distance),
                    {select(takes, over * light.diffuse, ray.light.diffuse),
                     select(takes, over * light.glossy, ray.light.glossy)},
                    total,
                    min(pick, 0.99999994)};
    return next;
}

TwoParts chosen_light(LampRay ray)
{
    TwoParts light = {ray.total * ray.light.diffuse, ray.total * ray.light.glossy};
    return light;
}

// A ray to one of the environment's lamps, for what of their light the lobe's rays do not read: they read levels of blur
// that lack it. rays: as in lobe_ray; off: two normally distributed numbers, the place on the lamp.
LampRay environment_lamp_ray(Environment e, RayOrigin o, Real rays, Real pick, vec2 off)
{
    LampRay ray = no_lamp_ray(pick);
    for (int i = 0; i < lamp_count(e); ++i) {
        Real deviation = sqrt(lamp_variance(e, i));
        vec3 place = vec3(deviation * off.x, deviation * off.y, 1.0);
        vec3 L = in_world(e, normalize(orthonormal_frame(lamp_direction(e, i)) * place));
        Real share = share_of_coarser(variance_of_ray(density_of_rays(e, o, L), rays), lamp_variances(e));
        Arrival a = {L, share * lamp_light(e, i)};
        ray = or_lamp(ray, L, 1.0e30, reflected_parts(e, o.receiver, a));
    }
    return ray;
}
