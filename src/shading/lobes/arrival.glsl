// Light of sources without size, as it arrives at a point. Needs no hooks.

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
