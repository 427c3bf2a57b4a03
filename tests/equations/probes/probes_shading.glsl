// The passes of src/shading, called as probes.glsl calls the equations; and the choice between all probes. Included
// after it.

#include "shading/choices.glsl"

// The hooks of the passes over an environment that is a formula: brighter above, a little darker with the level.
struct Environment {
    Real brightness;
    Real variance;
    Real base_level;
    int samples;
};

int sample_count(Environment e) { return e.samples; }

// Points without structure; the angle by the rational circle.
vec3 cap_point(Environment e, int k)
{
    vec2 t = turn((Real(k) + 0.25) / Real(e.samples));
    return vec3((Real(k) + 0.5) / Real(e.samples), t.x, t.y);
}

vec3 lobe_point(Environment e, int k)
{
    vec3 p = cap_point(e, k);
    return vec3(log2(p.x), p.y, p.z);
}

vec2 pixel_point(Environment e, int k) { return vec2((Real(k) + 0.5) / Real(e.samples) - 0.5, 0.25); }

Real level_one_variance(Environment e) { return e.variance; }

int lamp_count(Environment e) { return e.samples / 6; }
vec3 lamp_direction(Environment e, int k) { return normalize(vec3(0.3, 0.9 - Real(k), e.brightness)); }
vec3 lamp_light(Environment e, int k) { return e.brightness * vec3(0.02, 0.03, 0.01 + 0.01 * Real(k)); }
vec2 lamp_variances(Environment e) { return vec2(e.variance, 4.0 * e.variance); }

vec3 environment_report_radiance(Environment e, vec3 d, Real level)
{
    vec3 n = normalize(d);
    return e.brightness * vec3(1.5 + n.y, 1.5 + 0.5 * n.x * n.z, 1.0 / (2.0 + min(level, 8.0)));
}

vec3 environment_report_texel(Environment e, vec3 d, Real level) { return environment_report_radiance(e, d, level); }

struct LightSum {
    vec3 first;
    vec3 second;
};

LightSum no_light(Environment e)
{
    LightSum none = {vec3(0.0 * e.brightness), vec3(0.0)};
    return none;
}

LightSum with_light(Environment e, LightSum sum, vec3 d, Real level, vec2 weights)
{
    vec3 light = environment_report_radiance(e, d, level);
    LightSum more = {sum.first + weights.x * light, sum.second + weights.y * light};
    return more;
}

vec3 first_light(Environment e, LightSum sum) { return (e.brightness / e.brightness) * sum.first; }
vec3 second_light(Environment e, LightSum sum) { return (e.brightness / e.brightness) * sum.second; }

Real report_base_level(Environment e) { return e.base_level; }

int has_stretch() { return 1; }
#include "shading/all.glsl"

// A table that is a formula.
Real albedo_entry(Real column, Real row, int part) { return 0.01 * column + 0.02 * row + 0.1 * Real(part); }
#include "shading/lobes/albedo.glsl"
#include "shading/lobes/layers.glsl"

Environment formula(Real brightness)
{
    Environment e = {brightness, Real(1.5e-4), Real(9.5), 12};
    return e;
}

// A normal, and a view at most 60 degrees or so off it.
vec3 view_near(vec3 N, Inputs i) { return normalize(N + 0.8 * direction(i.c, i.d)); }

// How the mirrored direction turns in a pixel, by up to `most`.
ShinyPoint shiny_point(vec3 N, vec3 V, Inputs i, Real most)
{
    ShinyPoint s = {N, V, most * i.f * direction(i.g, i.h), most * i.g * direction(i.h, i.f)};
    return s;
}

Outputs shading_ggx(Inputs i)
{
    vec3 N = direction(i.a, i.b);
    vec3 V = view_near(N, i);
    ShinyPoint s = shiny_point(N, V, i, 0.1);
    Mirror m = {s, mirrored(vec3(0.6, 0.0, 0.8), V), vec2(decades(i.e, 1.0e-4, 1.0)), vec3(0.0), probe_albedo(i.g, i.h)};
    LobeLight light = specular_ggx(formula(1.0 + i.h), m);
    return outputs(light.plain, light.grazing.x);
}

Outputs shading_facets(Inputs i)
{
    vec3 h = upper_direction(i.a, i.b);
    vec2 alpha = vec2(0.1 + 0.9 * i.d, 0.1 + 0.9 * i.f);
    Metallic m = {vec3(i.e), i.f, alpha, vec3(1.0, 0.0, 0.0), 1.0};
    Metallic wide = widened(m, 0.1 * h, 0.2 * h);
    return outputs(vec3(smith_of(h, alpha), slope_of(h, 1.0 - h.z * h.z, h.z * h.z, alpha), wide.alpha.x + wide.alpha.y),
                   select(is_stretched(alpha), 1.0, 0.0));
}

Outputs shading_lobe_sample(Inputs i)
{
    vec3 view = normalize(upper_direction(i.a, i.b) + vec3(0.0, 0.0, 0.2));
    vec2 t = turn(i.c);
    LobeSampling lobe = lobe_sampling(view, vec2(0.1 + 0.9 * i.d, 0.1 + 0.9 * i.f), 0.025);
    LobeSample s = lobe_sample(lobe, vec3(0.9 * i.e, t.x, t.y));
    return outputs(s.direction, s.weight + s.size + s.grazing + s.variance + smith_of_mirrored(lobe, view, i.g, i.h));
}

Outputs shading_lamps(Inputs i)
{
    vec3 N = direction(i.a, i.b);
    vec3 V = view_near(N, i);
    ShinyPoint s = {N, V, 0.2 * direction(i.g, i.h), 0.2 * direction(i.h, i.f)};
    Mirror m = {s, mirrored(vec3(0.6, 0.0, 0.8), V), vec2(0.1 + 0.9 * i.e, 0.1 + 0.9 * i.c), mirrored(N, vec3(0.8, 0.0, 0.6)),
                probe_albedo(i.g, i.h)};
    LobeSampling lobe = lobe_sampling(in_frame(mirror_frame(m), V), m.alpha, 0.025);
    LobeLight light = lamps_ggx(formula(1.0 + i.h), m, lobe, i.f, 0.0001 * i.g);
    LampWeights w = lamp_weights(lobe, upper_direction(i.c, i.h), 0.1 * i.g);
    Phong p = {vec3(i.e), vec3(i.f, i.g, i.h), decades(i.e, 0.01, 100.0)};
    vec3 phong = lamps_phong(formula(1.0 + i.f), p, s, pixel_blur_phong(s, p.exponent, 0.025), 0.025);
    Real pixel = density_in_pixel(footprint_of(s), normalize(mirrored(N, V) + 0.1 * i.a * s.mirrored_dx));
    return outputs(vec3(light.plain.x + 0.1 * light.grazing.y, w.parts.x + w.parts.y + w.variance, phong.x), 0.01 * pixel);
}

Outputs shading_phong(Inputs i)
{
    vec3 N = direction(i.a, i.b);
    vec3 V = view_near(N, i);
    Phong p = {vec3(i.e), vec3(i.f, i.g, i.h), decades(i.e, 0.01, 1.0e6)};
    return outputs(specular_phong(formula(1.0), p, shiny_point(N, V, i, 0.1), mirrored(vec3(0.6, 0.0, 0.8), V)), i.h);
}

Outputs shading_phong_report(Inputs i)
{
    vec3 N = direction(i.a, i.b);
    vec3 V = view_near(N, i);
    Phong p = {vec3(i.e), vec3(i.f, i.g, i.h), decades(i.e, 0.01, 1000.0)};
    return outputs(specular_phong_report(formula(1.0), p, N, V, mirrored(vec3(0.6, 0.0, 0.8), V)), i.h);
}

Outputs shading_pipeline_report(Inputs i)
{
    vec3 N = direction(i.a, i.b);
    vec3 V = view_near(N, i);
    Phong p = {vec3(i.e), vec3(i.f, i.g, i.h), decades(i.e, 0.01, 1000.0)};
    ReportTone t = {1.0 + 1.2 * i.f, decades(i.g, 0.1, 1000.0), 0.4 + i.h, 0.45 + 0.55 * i.f};
    vec3 ambient = ambient_report(t, vec3(i.a, i.b, i.c), vec3(i.d, i.e, i.f), 2.0 * i.g);
    return outputs(specular_pipeline_report(formula(1.0), t, p, N, V, mirrored(vec3(0.6, 0.0, 0.8), V)) + 0.1 * ambient,
                   toned_report(t, vec3(4.0 * i.h, i.a, i.b)).x +
                       0.1 * middle_level_pipeline(formula(1.0), p.exponent) + 0.01 * first_term_of_pipeline(formula(1.0)));
}

Outputs shading_middle_levels(Inputs i)
{
    vec3 N = direction(i.a, i.b);
    vec3 V = view_near(N, i);
    ShinyPoint s = shiny_point(N, V, i, 0.1);
    Mirror m = {s, mirrored(vec3(0.6, 0.0, 0.8), V), vec2(decades(i.e, 1.0e-4, 1.0)), vec3(0.0), vec2(0.5, 0.1)};
    Environment e = formula(1.0);
    LobeSampling lobe = lobe_sampling(in_frame(carried_frame(N, V, m.across), V), m.alpha, 0.025);
    PixelBlur pixel = pixel_blur(s, lobe.variance, 0.025);
    Real exponent = decades(i.e, 0.01, 1000.0);
    Real phong = middle_level_phong(e, s, exponent) + matched_level_phong(-4.0 * i.h, exponent, pixel, vec2(0.025, 0.04));
    Real report = middle_level_report(e, exponent) + report_level_phong(first_term_of_report(e), 0.5 + 0.5 * i.g, 10.0);
    return outputs(vec3(0.2 * middle_level_ggx(e, m), 0.2 * phong, 0.2 * report),
                   pixel.moved + pixel.share + 0.2 * matched_level_ggx(lobe.variance, pixel, 100.0));
}

LocalLight some_lamp(Inputs i)
{
    LocalLight l = {vec3(4.0 * i.e - 2.0, 4.0 * i.f - 2.0, 3.0), vec3(i.g, i.h, 1.0), direction(i.h, i.g), 0.2 * i.a, 0.9, 0.3};
    return l;
}

Outputs shading_direct_metallic(Inputs i)
{
    vec3 N = direction(i.a, i.b);
    Metallic m = {vec3(i.e, i.f, i.g), i.h, vec2(0.2 + 0.8 * i.a, 0.2 + 0.8 * i.d), mirrored(N, vec3(0.8, 0.0, 0.6)), 1.0};
    Arrival a = arrival_from(some_lamp(i), vec3(i.b, i.c, i.d));
    return outputs(direct_metallic(m, probe_albedo(i.g, i.h), N, view_near(N, i), a), dot(a.direction, N));
}

Outputs shading_direct_phong(Inputs i)
{
    vec3 N = direction(i.a, i.b);
    Phong p = {vec3(i.e), vec3(i.f, i.g, i.h), decades(i.e, 0.01, 100.0)};
    Arrival a = arrival_from(some_lamp(i), vec3(i.b, i.c, i.d));
    return outputs(direct_phong(p, N, view_near(N, i), a),
                   alpha_in_pixel(i.a, i.b * direction(i.c, i.d), i.e * direction(i.f, i.g)));
}

// No light at the edge of hides_highlight's bounds: what is drawn jumps a little there.
Arrival light_near(ShinyPoint s, Inputs i)
{
    Arrival a = {normalize(mirrored(s.normal, s.view) + 0.1 * i.h * s.mirrored_dx), vec3(i.a, i.b, 1.0)};
    return a;
}

Outputs shading_direct_in_pixel(Inputs i)
{
    vec3 N = direction(i.a, i.b);
    ShinyPoint s = {N, view_near(N, i), 0.1 * direction(i.g, i.h), 0.1 * direction(i.h, i.f)};
    Metallic m = {vec3(i.e, i.f, i.g), i.h, vec2(0.02 + 0.08 * i.e), vec3(0.0), 1.0};
    Phong p = {vec3(i.e), vec3(i.f, i.g, i.h), decades(i.e, 200.0, 1.0e4)};
    Arrival a = light_near(s, i);
    vec3 metal = direct_metallic_in_pixel(m, probe_albedo(i.g, i.h), s, a);
    vec3 looks = direct_metallic_in_looks(m, probe_albedo(i.g, i.h), s, a);
    vec3 phong = direct_phong_in_pixel(p, s, a);
    Real hidden = select(hides_highlight(s, vec2(0.05 + 0.2 * i.d), a.direction), 1.0, 0.0);
    return outputs(vec3(0.01 * (metal.x + looks.z), 0.01 * phong.y, dot(normal_of_look(s, 11), s.view)),
                   0.3 * hidden);
}

Outputs shading_ambient(Inputs i)
{
    return outputs(ambient_light(vec3(i.a, i.b, i.c), vec3(i.d, i.e, i.f), 2.0 * i.g), i.h);
}

// A point for drawing: (xi2, cos 2 pi xi1, sin 2 pi xi1).
vec3 some_point(Inputs i)
{
    vec2 t = turn(i.g);
    return vec3(0.001 + 0.9 * i.h, t.x, t.y);
}

// Densities are of a light above the horizon, away from where they jump.
Outputs shading_drawn_facets_of(Inputs i, vec2 alpha)
{
    vec3 N = direction(i.a, i.b);
    ShinyPoint s = {N, view_near(N, i), vec3(0.0), vec3(0.0)};
    Metallic m = {vec3(i.e), i.f, alpha, mirrored(N, vec3(0.8, 0.0, 0.6)), 1.0};
    vec3 L = normalize(N + 0.8 * direction(i.f, i.e));
    vec3 x = facet_frame(m, N) * vec3(1.0, 0.0, 0.0);
    return outputs(drawn_by_facets(m, s, some_point(i)), density_by_facets(m, s, L) + x.x);
}

Outputs shading_drawn_facets(Inputs i) { return shading_drawn_facets_of(i, vec2(0.1 + 0.9 * i.e)); }

Outputs shading_drawn_facets_two(Inputs i)
{
    return shading_drawn_facets_of(i, vec2(0.1 + 0.9 * i.e, 0.1 + 0.9 * i.f));
}

Outputs shading_drawn_phong(Inputs i)
{
    vec3 N = direction(i.a, i.b);
    ShinyPoint s = {N, view_near(N, i), vec3(0.0), vec3(0.0)};
    Phong p = {vec3(i.e), vec3(i.f), decades(i.e, 0.5, 100.0)};
    vec3 L = normalize(N + 0.8 * direction(i.f, i.e));
    return outputs(drawn_by_phong(p, s, some_point(i)), density_by_phong(p, s, L));
}

Outputs shading_drawn_cosine(Inputs i)
{
    vec3 N = direction(i.a, i.b);
    return outputs(drawn_by_cosine(N, some_point(i)),
                   density_by_cosine(N, direction(i.c, i.d)) + luminance_of(vec3(i.d, i.e, i.f)) +
                       variance_of_ray(0.1 + i.d, 1.0 + 3.0 * i.e));
}

SightRay some_sight(Inputs i)
{
    SightRay s = {vec3(0.0, 0.0, 3.0),   vec3(0.002 * i.e, 0.0, 0.0),
                  vec3(0.0),             vec3(0.3 * i.a - 0.15, 0.3 * i.b - 0.15, -1.0),
                  vec3(0.01, 0.0, 0.0),  vec3(0.0, 0.01, 0.002 * i.f)};
    return s;
}

// Around the middle of the picture, so that it is met.
Triangle some_triangle(Inputs i)
{
    Triangle t = {vec3(-1.5 - 0.5 * i.c, -1.5, 0.5 * i.d), vec3(3.5 + i.e, 0.2 * i.f, 0.3 * i.g),
                  vec3(0.2 * i.h, 3.5 + i.c, 0.3 * i.d)};
    return t;
}

Facet some_facet(Inputs i) { return facet_at(some_sight(i), some_triangle(i), meeting_with(some_sight(i), some_triangle(i))); }

Outputs shading_facet(Inputs i)
{
    Facet f = some_facet(i);
    return outputs(f.position, f.at.a + f.at.b_dx + f.at.c_dx + f.at.b_dy + f.at.c_dy + f.distance);
}

Outputs shading_steps(Inputs i)
{
    vec3 moved = moved_on_plane(direction(i.a, i.b), vec3(0.1, 0.2, 0.3) + 3.0 * direction(i.a, i.b), i.c,
                                vec3(i.d, i.e, i.f), vec3(i.g, i.h, i.a));
    return outputs(moved, largest_part(moved) + finite_or_zero(i.h) + finite_or_zero(1.0e16 + i.h));
}

Turning some_turning(Inputs i)
{
    return turning_of(2.0 * direction(i.a, i.b) , 0.1 * direction(i.c, i.d), 0.1 * direction(i.e, i.f));
}

Outputs shading_turning(Inputs i)
{
    Turning t = some_turning(i);
    return outputs(t.normal + t.dx + t.dy, i.h);
}

Outputs shading_mapped(Inputs i)
{
    vec3 mapped = mapped_normal(direction(i.a, i.b), vec3(1.0, i.c, i.d), 1.0, vec3(i.e, i.f, 0.6 + 0.4 * i.g), i.h);
    vec3 change = mirrored_change(direction(i.a, i.b), direction(i.c, i.d), 0.1 * direction(i.e, i.f), vec3(i.g, 0.0, i.h));
    return outputs(mapped, change.x + change.y + change.z);
}

Outputs shading_surface(Inputs i)
{
    Turning t = some_turning(i);
    Surface s = surface_at(some_sight(i), some_facet(i), t, vec3(0.4, 0.3, 0.9) + 0.4 * direction(i.e, i.f), 1.0);
    vec3 mirrored_changes = s.mirrored_dx + 2.0 * s.mirrored_dy;
    return outputs(s.view + s.normal, mirrored_changes.x + mirrored_changes.y + s.depth);
}

Outputs shading_material(Inputs i)
{
    Phong p = phong_from_metallic(vec3(i.a, i.b, i.c), i.d, 0.3 + 0.7 * i.e);
    return outputs(p.diffuse + p.specular, alpha_of_roughness(i.f) + 0.001 * p.exponent);
}

Texel some_texel(Real a, Real b)
{
    Texel t = {a, b, 0.5 + 0.5 * a, 0.5 + 0.5 * b};
    return t;
}

Material some_material(Inputs i)
{
    Texels texels = {
#define TEXTURE(name, number, transfer, object, key) some_texel(i.a + 0.01 * Real(number), i.b),
#define NORMAL_TEXTURE(name, number, object, key) some_texel(i.c, i.b),
#include "shading/material/textures.h"
    };
    Material factors = {
#define COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture) vec3(i.d, i.e, i.f), i.g,
#define COLOR(name, number, value, object, key, texture) vec3(i.e, i.f, i.d),
#define SCALAR(name, number, value, object, key, texture, channel) i.h,
#define ROUGHNESS(name, factor, number, value, object, key, texture, channel) i.g,
#define STRENGTH(name, factor, number, value, object, key, texture, channel) i.f,
#include "shading/material/parameters.h"
    };
    return material_of(factors, texels, some_texel(i.h, i.g), alpha_blend);
}

Outputs shading_parameters(Inputs i)
{
    Material m = some_material(i);
    return outputs(m.base_color + m.emissive + vec3(m.opacity + opacity_of(alpha_mask, i.a, i.b)),
                   m.alpha + m.metallic + m.occlusion);
}

Outputs shading_layers(Inputs i)
{
    Metallic coat = facets_coat(some_material(i), 1.0);
    vec3 V = direction(i.f, i.g);
    return outputs(left_below(i.a, coat, vec2(0.5 + 0.4 * i.b, 0.1 * i.c)) + left_below_at(i.a, coat, view_near(V, i), V),
                   coat.alpha.x);
}

Outputs shading_albedo(Inputs i)
{
    vec2 albedo = albedo_of(i.a, i.b);
    return outputs(vec3(albedo.x, albedo.y, 0.0), 0.0 * i.c);
}

Outputs shading_arrivals(Inputs i)
{
    Arrival near = arrival_of(some_lamp(i), 1, vec3(i.b, i.c, i.d));
    Arrival far = arrival_of(some_lamp(i), 0, vec3(i.b, i.c, i.d));
    return outputs(near.direction + far.direction, far.illuminance.x + 0.1 * near.illuminance.y);
}

Outputs shading_texture(Inputs i)
{
    TexturePoint p = {vec2(i.a, i.b), vec2(0.05 * i.c, 0.02 * i.d), vec2(0.03 * i.e, 0.04 * i.f)};
    TextureFootprint f = texture_footprint(p, vec2(256.0, 128.0), 7.0);
    return outputs(vec3(f.level, f.ratio, 0.01 * f.longer2), repeated(8.0 * i.g - 4.0) + repeated_mirrored(8.0 * i.h - 4.0) + snapped(i.a, 8.0) + nearest_level(3.0 * i.b));
}

Outputs probe(int which, Inputs i)
{
#define PROBE(number, name, lanes_absolute, lanes_relative, glsl_absolute, glsl_relative)                    \
    if (which == number)                                                                                     \
        return name(i);
#include "tests/equations/probes/probes_list.h"
#undef PROBE
    Outputs none = {Real(0.0), Real(0.0), Real(0.0), Real(0.0)};
    return none;
}
