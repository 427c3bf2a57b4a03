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

// alpha^2 with the bend of the surface inside a pixel added: a highlight smaller than a pixel is drawn larger and
// dimmer instead of twinkling. The differentials are of the mirrored direction, which turns twice as far as the
// normal; a box of width w has variance w^2 / 12. [Tokuyoshi and Kaplanyan 2019, "Improved geometric specular
// antialiasing", JCGT 10(2): alpha^2 + 2 variance of slopes] Witness: the differentials of a sphere.
Real alpha_in_pixel(Real alpha, vec3 mirrored_dx, vec3 mirrored_dy)
{
    Real bend2 = 0.25 * (dot(mirrored_dx, mirrored_dx) + dot(mirrored_dy, mirrored_dy));
    return min(sqrt(alpha * alpha + bend2 * 0.08333333333333333), 1.0);
}
