// From the triangle that a camera ray meets to the surface that the passes need. Needs no hooks.

// A camera ray through a position in the picture, and its changes to the next pixel right and below. The direction
// need not have unit length.
struct SightRay {
    vec3 origin;
    vec3 origin_dx;
    vec3 origin_dy;
    vec3 direction;
    vec3 direction_dx;
    vec3 direction_dy;
};

// A triangle in world space: a corner, and the edges from it to the other two.
struct Triangle {
    vec3 corner;
    vec3 edge1;
    vec3 edge2;
};

// An attribute at a triangle's corners.
struct Corners {
    vec3 a;
    vec3 b;
    vec3 c;
};

// The intersection of a ray with a triangle: distance in multiples of the ray's direction, weights of corners 1 and 2.
struct Meeting {
    Real distance;
    Real u;
    Real v;
};

// The intersection of a ray with a triangle's plane, unless the ray lies in it. Weights are clamped to the triangle,
// which the ray through the centre of a covered pixel may miss by a rounding error. [Moller and Trumbore 1997]
// Witness: a point composed of the corners is found again (tests/equations).
Meeting meeting_with(SightRay s, Triangle t)
{
    vec3 way = s.origin - t.corner;
    vec3 p = cross(s.direction, t.edge2);
    vec3 q = cross(way, t.edge1);
    Real determinant = dot(t.edge1, p);
    Real inverse = 1.0 / select(abs(determinant) < 1.0e-37, 1.0e-37, determinant);
    Real u = clamp(inverse * dot(way, p), 0.0, 1.0);
    Real v = clamp(inverse * dot(s.direction, q), 0.0, 1.0);
    Real over = 1.0 / max(u + v, 1.0);
    Meeting m = {inverse * dot(t.edge2, q), over * u, over * v};
    return m;
}

// Weights of the three corners, and the changes of those of corners 1 and 2 to the next pixel right and below.
struct Barycentric {
    Real a;
    Real b;
    Real c;
    Real b_dx;
    Real c_dx;
    Real b_dy;
    Real c_dy;
};

// The visible point of a triangle. normal: of the triangle's counter-clockwise side, not of unit length.
struct Facet {
    vec3 position;
    vec3 normal;
    Real distance;
    Barycentric at;
};

// Displacement of the visible point on the plane of that normal when the ray's origin and direction change by the two
// steps. [Igehy 1999, "Tracing ray differentials"]
// Witness: the difference of two intersections with the plane (tests/equations).
vec3 moved_on_plane(vec3 direction, vec3 normal, Real distance, vec3 origin_step, vec3 direction_step)
{
    vec3 moved = origin_step + distance * direction_step;
    Real towards = dot(direction, normal);
    Real safe = select(abs(towards) < 1.0e-30, 1.0e-30, towards);
    return moved - (dot(moved, normal) / safe) * direction;
}

// The largest absolute value of the components.
// Witness: the largest of three numbers without their signs (tests/equations).
Real largest_part(vec3 v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); }

// A rate of change, or 0 if it overflowed: lookups that depend on it must stay finite.
// Witness: both sides of 1e15 (tests/equations).
Real finite_or_zero(Real rate) { return select(abs(rate) < 1.0e15, rate, 0.0); }

// The visible point, with the changes of its weights.
// Witness: the weights of the points that the rays of neighbouring pixels meet (tests/equations).
Facet facet_at(SightRay s, Triangle t, Meeting m)
{
    // In units of the triangle's size: fourth powers of the edges below would otherwise leave the range of floats.
    Real longest = clamp(max(largest_part(t.edge1), largest_part(t.edge2)), 1.0e-30, 1.0e30);
    Real unit = 1.0 / longest;
    vec3 e1 = unit * t.edge1;
    vec3 e2 = unit * t.edge2;
    vec3 normal = cross(e1, e2);
    Real scale = unit / max(dot(normal, normal), 1.0e-36);
    vec3 dx = moved_on_plane(s.direction, normal, m.distance, s.origin_dx, s.direction_dx);
    vec3 dy = moved_on_plane(s.direction, normal, m.distance, s.origin_dy, s.direction_dy);
    vec3 across_b = scale * cross(e2, normal);
    vec3 across_c = scale * cross(normal, e1);
    Barycentric at = {1.0 - m.u - m.v,
                      m.u,
                      m.v,
                      finite_or_zero(dot(dx, across_b)),
                      finite_or_zero(dot(dx, across_c)),
                      finite_or_zero(dot(dy, across_b)),
                      finite_or_zero(dot(dy, across_c))};
    Facet f = {t.corner + m.u * t.edge1 + m.v * t.edge2, normal, m.distance, at};
    return f;
}

// A shading normal, and its changes to the next pixel right and below.
struct Turning {
    vec3 normal;
    vec3 dx;
    vec3 dy;
};

// Normalises an interpolated normal of any length and its changes.
// Witness: the difference of two normalised vectors (tests/equations).
Turning turning_of(vec3 sum, vec3 sum_dx, vec3 sum_dy)
{
    Real inverse = inversesqrt(max(dot(sum, sum), 1.0e-30));
    vec3 normal = inverse * sum;
    vec3 dx = inverse * sum_dx;
    vec3 dy = inverse * sum_dy;
    Turning t = {normal, dx - dot(normal, dx) * normal, dy - dot(normal, dy) * normal};
    return t;
}

// The normal given by a normal map. code: the map's value, in [0, 1]; along: interpolated tangent of any length,
// normalised here so that the strength of bumps does not depend on the mesh; side: 1, or -1 for a mirrored bitangent.
// [glTF 2.0, 3.9.3] Witness: codes along each axis of the frame (tests/equations).
vec3 mapped_normal(vec3 normal, vec3 along, Real side, vec3 code, Real scale)
{
    vec3 tangent = inversesqrt(max(dot(along, along), 1.0e-30)) * along;
    vec3 bitangent = side * cross(normal, tangent);
    vec3 mapped = ((2.0 * code.x - 1.0) * scale) * tangent + ((2.0 * code.y - 1.0) * scale) * bitangent +
                  (2.0 * code.z - 1.0) * normal;
    Real length2 = dot(mapped, mapped);
    return select(length2 > 1.0e-12, inversesqrt(max(length2, 1.0e-12)) * mapped, normal);
}

// Change of the mirrored direction from the changes of view and normal, at most 1 long: a footprint of half the sky
// means that the triangle is seen edge on, and larger ones mean nothing more.
// Witness: the difference of two mirrored directions (tests/equations).
vec3 mirrored_change(vec3 normal, vec3 view, vec3 normal_change, vec3 view_change)
{
    Real cosine_change = dot(normal_change, view) + dot(normal, view_change);
    vec3 d = 2.0 * (cosine_change * normal + dot(normal, view) * normal_change) - view_change;
    Real length2 = dot(d, d);
    return select(length2 > 1.0, inversesqrt(max(length2, 1.0)) * d, d);
}

// A visible point as the light passes need it.
struct Surface {
    Real depth; // distance from the ray's origin, metres
    vec3 view;  // towards the viewer
    vec3 normal; // shading normal, facing the viewer
    vec3 mirrored_dx; // change of the mirrored direction over a pixel
    vec3 mirrored_dy;
};

// The visible point of a facet. mapped: the normal with the normal map, turning: without it; handedness: -1 if the
// instance's transform mirrors, else 1. A normal whose cosine with the view is below 0.001 is bent towards the
// viewer.
// Witness: a sphere's position, normal and mirrored directions in closed form (tests/equations).
Surface surface_at(SightRay s, Facet f, Turning turning, vec3 mapped, Real handedness)
{
    Real length2 = dot(s.direction, s.direction);
    Real inverse = inversesqrt(max(length2, 1.0e-30));
    vec3 view = -(inverse * s.direction);
    Real side = select(handedness * dot(f.normal, view) < 0.0, -1.0, 1.0);
    vec3 normal = facing_normal(side * mapped, view, 1.0e-3);
    vec3 view_dx = -(inverse * (s.direction_dx - dot(s.direction_dx, view) * view));
    vec3 view_dy = -(inverse * (s.direction_dy - dot(s.direction_dy, view) * view));
    Surface surface = {f.distance * sqrt(length2), view, normal,
                       mirrored_change(normal, view, side * turning.dx, view_dx),
                       mirrored_change(normal, view, side * turning.dy, view_dy)};
    return surface;
}

// The report's parameters that approximate metal and dielectric.
// Witness: both, by the reflectances of equations/fresnel.glsl (tests/equations).
Phong phong_from_metallic(vec3 base, Real metalness, Real alpha)
{
    Phong p = {(1.0 - metalness) * base, base_reflectance(base, metalness), phong_exponent(alpha)};
    return p;
}

// Parameters of the report's model that replace the approximation of metal and dielectric where `given`, 0 or 1, is 1.
struct GivenPhong {
    vec3 diffuse;
    vec3 specular;
    Real exponent;
    vec3 given; // diffuse, specular, exponent
};
