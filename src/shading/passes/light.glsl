// The passes of light over fragments. Hooks: see README.md.

Metallic metallic_of(Environment e, Material m)
{
    Metallic r = {m.base_color, m.metallic, m.alpha, compensation_of(e)};
    return r;
}

// A lobe over the base at a point: how much of it is there, 0 to 1, how it mirrors, and the share that it leaves to those below.
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
    vec2 albedo = albedo_of(dot(s.normal, s.view), facets.alpha);
    Layer layer = {there, s, facets, albedo, left_below(there, facets, albedo)};
    return layer;
}

// A fragment as direct light meets it: what all lights share is worked out once.
struct Receiver {
    ShinyPoint shiny;
    vec3 point;
    Material material;
    Phong phong;
    vec2 albedo;
#define LAYER(name, number, texture) Layer name;
#include "shading/lobes/layers.h"
};

// The lobe, or nothing of it where no lane has it.
Layer layer_or_none(Fragment f, Real there, Metallic facets, int number)
{
    Layer layer = {there, load_shine(f, 0), facets, vec2(0.0), vec3(1.0)};
    if (has_layers() != 0 && any_of(there > 0.0))
        layer = layer_at(f, there, facets, number);
    return layer;
}

Receiver receiver_at(Environment e, Fragment f)
{
    ShinyPoint s = load_shine(f, 0);
    Material m = load_material(f);
    Receiver r = {
        s,
        load3(f, column_position),
        m,
        load_phong(f),
        albedo_of(dot(s.normal, s.view), m.alpha),
#define LAYER(name, number, texture) layer_or_none(f, m.name, facets_##name(m, compensation_of(e)), number),
#include "shading/lobes/layers.h"
    };
    return r;
}

// `light` from below a lobe, and what that sends of light that arrives.
vec3 direct_through(Layer layer, vec3 light, Arrival a)
{
    return layer.there * direct_metallic_in_pixel(layer.facets, layer.albedo, layer.shiny, a) + layer.left * light;
}

// What a fragment sends to the viewer of light that arrives: in the report's own order of things by one look, as it has it.
vec3 direct_light(Environment e, Receiver r, Arrival a)
{
    if (levels_of(e) == levels_pipeline)
        return direct_phong(r.phong, r.shiny.normal, r.shiny.view, a);
    if (model_of(e) == model_phong)
        return direct_phong_in_pixel(r.phong, r.shiny, a);
    vec3 light = direct_metallic_in_pixel(metallic_of(e, r.material), r.albedo, r.shiny, a);
#define LAYER(name, number, texture)                       \
    if (has_layers() != 0 && any_of(r.name.there > 0.0)) \
        light = direct_through(r.name, light, a);
#include "shading/lobes/layers.h"
    return light;
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

void add_ambient(Environment e, Fragment f)
{
    ShinyPoint s = load_shine(f, 0);
    Material m = load_material(f);
    vec3 irradiance = environment_irradiance(e, turned(e, s.normal));
    Real brightness = ambient_brightness(e) * m.occlusion;
    vec3 light = vec3(0.0);
    if (levels_of(e) == levels_pipeline)
        light = ambient_report(report_tone(e), load3(f, column_diffuse), irradiance, brightness);
    else if (model_of(e) == model_phong)
        light = ambient_light(load3(f, column_diffuse), irradiance, brightness);
    else {
        vec2 albedo = albedo_of(dot(s.normal, s.view), m.alpha);
        light = ambient_light(reflectance_metallic(metallic_of(e, m), albedo).diffuse, irradiance, brightness);
        light = through_layers(e, f, m, light);
    }
    store3(f, column_irradiance, irradiance);
    store3(f, column_ambient, light);
}

// A point that mirrors, in the environment's own frame.
ShinyPoint in_environment(Environment e, ShinyPoint s)
{
    ShinyPoint t = {turned(e, s.normal), turned(e, s.view), turned(e, s.mirrored_dx), turned(e, s.mirrored_dy)};
    return t;
}

Mirror mirror_at(Environment e, ShinyPoint s, Real alpha)
{
    ShinyPoint t = in_environment(e, s);
    Mirror m = {t, turned(e, across_of(e)), alpha, albedo_of(dot(t.normal, t.view), alpha)};
    return m;
}

vec3 reflected_phong(Environment e, Phong p, ShinyPoint s)
{
    vec3 across = turned(e, across_of(e));
    if (levels_of(e) == levels_pipeline)
        return specular_pipeline_report(e, report_tone(e), p, s.normal, s.view, across);
    if (levels_of(e) == levels_report)
        return specular_phong_report(e, p, s.normal, s.view, across);
    return specular_phong(e, p, s, across);
}

vec3 reflected_metallic(Environment e, Metallic m, ShinyPoint s)
{
    Mirror mirror = mirror_at(e, s, m.alpha);
    LobeLight light = specular_ggx(e, mirror);
    Reflectance r = reflectance_metallic(m, mirror.albedo);
    return r.plain * light.plain + r.grazing * light.grazing;
}

// The level at which the base's lobe is read in its middle, as a part of the levels that there are.
Real middle_level(Environment e, Fragment f)
{
    ShinyPoint s = load_shine(f, 0);
    if (model_of(e) == model_ggx)
        return part_of_levels(middle_level_ggx(e, mirror_at(e, s, load(f, column_alpha))), highest_level(e));
    Real exponent = load(f, column_exponent);
    if (levels_of(e) == levels_pipeline)
        return part_of_levels(middle_level_pipeline(e, exponent), highest_report_level(e));
    if (levels_of(e) == levels_report)
        return part_of_levels(middle_level_report(e, exponent), highest_report_level(e));
    return part_of_levels(middle_level_phong(e, in_environment(e, s), exponent), highest_level(e));
}

// `light` from below a lobe, and what that mirrors of the environment.
vec3 reflected_through(Environment e, Layer layer, vec3 light)
{
    return layer.there * reflected_metallic(e, layer.facets, layer.shiny) + layer.left * light;
}

void add_specular(Environment e, Fragment f)
{
    ShinyPoint s = load_shine(f, 0);
    vec3 light = vec3(0.0);
    if (model_of(e) == model_phong)
        light = reflected_phong(e, load_phong(f), in_environment(e, s));
    else {
        Material m = load_material(f);
        light = reflected_metallic(e, metallic_of(e, m), s);
#define LAYER(name, number, texture)                                                                          \
    if (has_layers() != 0 && any_of(m.name > 0.0))                                                                                 \
        light = reflected_through(e, layer_at(f, m.name, facets_##name(m, compensation_of(e)), number), light);
#include "shading/lobes/layers.h"
    }
    store3(f, column_reflected, light);
}

// `sum` and the lamps through a level's blur, of which a share is read. d: in the environment's own frame.
vec3 with_lamps_blurred(Environment e, vec3 d, vec3 sum, Real share, Real variance)
{
    for (int i = 0; i < lamp_count(e); ++i) {
        vec3 off = d - lamp_direction(e, i);
        sum += (share * gaussian_on_sphere(dot(off, off), variance + lamp_variance(e, i))) * lamp_light(e, i);
    }
    return sum;
}

// What is behind everything in a direction of the world: the panorama, or it through the blurs of two levels.
vec3 background_light(Environment e, vec3 direction)
{
    vec3 d = turned(e, direction);
    vec3 light = vec3(0.0);
    if (background_of(e) == background_panorama)
        light = environment_panorama(e, d);
    else {
        vec3 lamps = vec3(0.0);
        for (int i = 0; i < 2; ++i)
            if (is_without_lamps(e, i) != 0)
                lamps = with_lamps_blurred(e, d, lamps, share_of_level(e, i), variance_of_level(e, i));
        light = environment_blurred(e, d) + lamps;
    }
    if (levels_of(e) == levels_pipeline)
        light = toned_report(report_tone(e), light);
    return light;
}
