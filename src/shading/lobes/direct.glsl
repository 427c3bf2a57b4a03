// Lights without size. Needs no hooks.

// A light at a place; a spot when cos_outer > -1. axis is the way the light travels.
struct LocalLight {
    vec3 position;
    vec3 intensity; // candela
    vec3 axis;
    Real inverse_range; // 1/m
    Real cos_inner;
    Real cos_outer;
};

// Light as it arrives at a point: where it comes from, and how much through a surface facing it, in lux.
struct Arrival {
    vec3 direction;
    vec3 illuminance;
};

// Light of a lamp at a point. Witness: the inverse square and the cone, in closed form.
Arrival arrival_from(LocalLight light, vec3 point)
{
    vec3 way = light.position - point;
    Real distance2 = max(dot(way, way), 1.0e-8);
    vec3 direction = inversesqrt(distance2) * way;
    Real cone = cone_attenuation(-dot(light.axis, direction), light.cos_inner, light.cos_outer);
    Arrival a = {direction, (cone * distance_attenuation(distance2, light.inverse_range)) * light.intensity};
    return a;
}

// Light of a lamp at a place, where `local` is not 0, or of one infinitely far away that lights all points alike.
// Witness: both.
Arrival arrival_of(LocalLight light, int local, vec3 point)
{
    Arrival a = {-light.axis, light.intensity};
    if (local != 0)
        a = arrival_from(light, point);
    return a;
}

// What of it a surface sends towards V: BRDF times illuminance times the cosine. Witness: an independent GGX in double
// (tests/draw).
vec3 direct_metallic(Metallic m, vec2 albedo, vec3 N, vec3 V, Arrival a)
{
    Real NL = dot(N, a.direction);
    vec3 f = brdf_metallic(m, albedo, N, V, select(NL > 0.0, a.direction, N));
    return select(NL > 0.0, (NL * f) * a.illuminance, vec3(0.0));
}

// The same with the report's BRDF. Witness: its closed form at 60 degrees and head on (tests/draw).
vec3 direct_phong(Phong p, vec3 N, vec3 V, Arrival a)
{
    Real NL = dot(N, a.direction);
    vec3 f = brdf_phong(p, N, V, select(NL > 0.0, a.direction, N));
    return select(NL > 0.0, (NL * f) * a.illuminance, vec3(0.0));
}

// Whether light from L may make a highlight that is narrower than what the surface mirrors within the pixel, so that one
// look through the middle may miss it, or take it for all of the pixel. A lobe of roughness alpha is about 2 alpha wide
// in mirrored directions. Witness: both sides of either bound.
Mask hides_highlight(ShinyPoint s, Real alpha, vec3 L)
{
    Real turn2 = dot(s.mirrored_dx, s.mirrored_dx) + dot(s.mirrored_dy, s.mirrored_dy);
    vec3 off = mirrored(s.normal, s.view) - L;
    Real reach = sqrt(turn2) + 6.0 * alpha;
    return turn2 > alpha * alpha && dot(off, off) < reach * reach;
}

// The normal at look i of 64 in the pixel, eight by eight: for a viewer who does not move, the one that mirrors as the surface
// does there. Nothing mirrored goes below the horizon: a pixel at a rim is wider than what is seen of the surface in it.
// Witness: its mirrored directions have the pixel's middle and variance.
vec3 normal_of_look(ShinyPoint s, int i)
{
    Real x = 0.125 * Real(i % 8) - 0.4375;
    Real y = 0.125 * Real(i / 8) - 0.4375;
    vec3 way = mirrored(s.normal, s.view) + x * s.mirrored_dx + y * s.mirrored_dy;
    return normalize(s.view + normalize(way + max(-dot(s.normal, way), 0.0) * s.normal));
}

// direct_metallic averaged over the pixel: by one look at a lobe that is as wide as lobe and pixel, or where that hides a
// highlight by 64 looks, each of an eighth of the width. Witness: quadrature over the pixel.
vec3 direct_metallic_in_pixel(Metallic m, vec2 albedo, ShinyPoint s, Arrival a)
{
    Metallic wide = {m.base, m.metalness, alpha_in_pixel(m.alpha, s.mirrored_dx, s.mirrored_dy), m.compensation};
    vec3 once = direct_metallic(wide, albedo, s.normal, s.view, a);
    Mask hidden = hides_highlight(s, m.alpha, a.direction);
    if (any_of(hidden)) {
        Real alpha = alpha_in_pixel(m.alpha, 0.125 * s.mirrored_dx, 0.125 * s.mirrored_dy);
        Metallic narrow = {m.base, m.metalness, alpha, m.compensation};
        vec3 sum = vec3(0.0);
        // In fours: some software devices end all loops after 65535 rounds together, which a thousand lights would use up.
        for (int i = 0; i < 64; i += 4)
            sum += direct_metallic(narrow, albedo, normal_of_look(s, i), s.view, a) +
                   direct_metallic(narrow, albedo, normal_of_look(s, i + 1), s.view, a) +
                   direct_metallic(narrow, albedo, normal_of_look(s, i + 2), s.view, a) +
                   direct_metallic(narrow, albedo, normal_of_look(s, i + 3), s.view, a);
        once = select(hidden, 0.015625 * sum, once);
    }
    return once;
}

// The same of direct_phong; its lobe is widened for the 64 looks alone. Witness: as before.
vec3 direct_phong_in_pixel(Phong p, ShinyPoint s, Arrival a)
{
    vec3 once = direct_phong(p, s.normal, s.view, a);
    Mask hidden = hides_highlight(s, phong_alpha(p.exponent), a.direction);
    if (any_of(hidden)) {
        Real alpha = alpha_in_pixel(phong_alpha(p.exponent), 0.125 * s.mirrored_dx, 0.125 * s.mirrored_dy);
        Phong narrow = {p.diffuse, p.specular, phong_exponent(alpha)};
        vec3 sum = vec3(0.0);
        for (int i = 0; i < 64; i += 4)
            sum += direct_phong(narrow, normal_of_look(s, i), s.view, a) +
                   direct_phong(narrow, normal_of_look(s, i + 1), s.view, a) +
                   direct_phong(narrow, normal_of_look(s, i + 2), s.view, a) +
                   direct_phong(narrow, normal_of_look(s, i + 3), s.view, a);
        once = select(hidden, 0.015625 * sum, once);
    }
    return once;
}
