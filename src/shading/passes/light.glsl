// The light passes over fragments: the base of the picture's model, and the lobes over it. Hooks: see README.md.

// A fragment prepared for direct light: values that do not depend on the light are computed once.
struct Receiver {
    ShinyPoint shiny;
    vec3 point;
#define BASE(name, number, layered) Base_##name name;
#include "shading/passes/bases.h"
#define LAYER(name, number, texture) Layer name;
#include "shading/lobes/layers.h"
};

Receiver receiver_at(Environment e, Fragment f)
{
    ShinyPoint s = load_shine(f, 0);
    Material m = load_material(f);
    Receiver r = {
        s,
        load3(f, column_position),
#define BASE(name, number, layered) base_##name(e, f, s),
#include "shading/passes/bases.h"
#define LAYER(name, number, texture) layer_or_none(f, m.name, facets_##name(m, compensation_of(e)), number),
#include "shading/lobes/layers.h"
    };
    return r;
}

// Arriving light that a lobe and the lobes below reflect, where `light` is the reflection of those below.
vec3 direct_through(Layer layer, vec3 light, Arrival a)
{
    return layer.there * direct_metallic_in_pixel(layer.facets, layer.albedo, layer.shiny, a) + layer.left * light;
}

// Arriving light that a fragment reflects to the viewer.
vec3 direct_light(Environment e, Receiver r, Arrival a)
{
    vec3 light = vec3(0.0);
#define BASE(name, number, layered)                \
    if (model_of(e) == number)                     \
        light = direct_base(e, r.name, r.shiny, a);
#include "shading/passes/bases.h"
    if (takes_layers(model_of(e)) != 0) {
#define LAYER(name, number, texture)                     \
    if (has_layers() != 0 && any_of(r.name.there > 0.0)) \
        light = direct_through(r.name, light, a);
#include "shading/lobes/layers.h"
    }
    return light;
}

void add_ambient(Environment e, Fragment f)
{
    ShinyPoint s = load_shine(f, 0);
    Material m = load_material(f);
    vec3 irradiance = environment_irradiance(e, turned(e, s.normal));
    Real brightness = ambient_brightness(e) * m.occlusion;
    vec3 light = vec3(0.0);
#define BASE(name, number, layered)                                            \
    if (model_of(e) == number)                                                 \
        light = ambient_base(e, base_##name(e, f, s), irradiance, brightness);
#include "shading/passes/bases.h"
    if (takes_layers(model_of(e)) != 0)
        light = through_layers(e, f, m, light);
    store3(f, column_irradiance, irradiance);
    store3(f, column_ambient, light);
}

// Light of the environment that a lobe and the lobes below reflect, where `light` is the reflection of those below.
vec3 reflected_through(Environment e, Layer layer, vec3 light)
{
    return layer.there * reflected_metallic(e, layer.facets, layer.shiny) + layer.left * light;
}

void add_specular(Environment e, Fragment f)
{
    ShinyPoint s = load_shine(f, 0);
    vec3 light = vec3(0.0);
#define BASE(name, number, layered)                         \
    if (model_of(e) == number)                              \
        light = reflected_base(e, base_##name(e, f, s), s);
#include "shading/passes/bases.h"
    if (takes_layers(model_of(e)) != 0) {
        Material m = load_material(f);
#define LAYER(name, number, texture)                                                                          \
    if (has_layers() != 0 && any_of(m.name > 0.0))                                                            \
        light = reflected_through(e, layer_at(f, m.name, facets_##name(m, compensation_of(e)), number), light);
#include "shading/lobes/layers.h"
    }
    store3(f, column_reflected, light);
}

// The level read at the centre of the base's lobe, as a fraction of the highest.
Real middle_level(Environment e, Fragment f)
{
    ShinyPoint s = load_shine(f, 0);
    Real level = 0.0;
#define BASE(name, number, layered)                        \
    if (model_of(e) == number)                             \
        level = level_of_base(e, base_##name(e, f, s), s);
#include "shading/passes/bases.h"
    return level;
}
