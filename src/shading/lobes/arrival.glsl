// Light that arrives at a point from sources without size. Needs no hooks.

// A point light, or a spot light if cos_outer > -1. axis: the direction in which its light travels.
struct LocalLight {
    vec3 position;
    vec3 intensity; // candela
    vec3 axis;
    Real inverse_range; // 1/m
    Real cos_inner;
    Real cos_outer;
};

// Light that arrives at a point: the direction towards its source, and the illuminance in lux of a surface facing it.
struct Arrival {
    vec3 direction;
    vec3 illuminance;
};

// Light of a point or spot light. Witness: the inverse square and the cone, in closed form (tests/equations).
Arrival arrival_from(LocalLight light, vec3 point)
{
    vec3 way = light.position - point;
    Real distance2 = max(dot(way, way), 1.0e-8);
    vec3 direction = inversesqrt(distance2) * way;
    Real cone = cone_attenuation(-dot(light.axis, direction), light.cos_inner, light.cos_outer);
    Arrival a = {direction, (cone * distance_attenuation(distance2, light.inverse_range)) * light.intensity};
    return a;
}

// Light of a point or spot light if `local` is not 0, else of a directional light, which is the same at all points.
// Witness: both cases in closed form (tests/equations).
Arrival arrival_of(LocalLight light, int local, vec3 point)
{
    Arrival a = {-light.axis, light.intensity};
    if (local != 0)
        a = arrival_from(light, point);
    return a;
}
