// Mappings of the sphere to images. +Y is up. u runs to the right and v down, both in [0, 1].

// Panorama coordinates of a direction: the middle of the panorama is +X, and +Z lies a quarter to the right of it.
// (The orientation of three.js, F3D and Blender.) Witness: the six axes; round trip.
vec2 equirectangular_from_direction(vec3 d)
{
    Real pole = abs(d.x) + abs(d.z);
    Real x = select(pole < 1.0e-30, 1.0, d.x); // atan(0, 0) is undefined in GLSL
    return vec2(atan(d.z, x) * 0.15915494309189535 + 0.5, acos(clamp(d.y, -1.0, 1.0)) * 0.3183098861837907);
}

// The inverse of equirectangular_from_direction. Witness: round trip.
vec3 direction_from_equirectangular(vec2 uv)
{
    Real phi = (uv.x - 0.5) * 6.283185307179586;
    Real theta = uv.y * 3.141592653589793;
    Real sine = sin(theta);
    return vec3(sine * cos(phi), cos(theta), sine * sin(phi));
}

// Direction, not normalised, to the point (s, t) in [-1, 1] of a cube face: 0 to 5 are +X -X +Y -Y +Z -Z.
// s and t beyond 1 continue the plane of the face. [Vulkan 1.3, "Cube Map Face Selection"] Witness: the six axes.
vec3 direction_from_cube(int face, Real s, Real t)
{
    if (face == 0)
        return vec3(1.0, -t, -s);
    if (face == 1)
        return vec3(-1.0, -t, s);
    if (face == 2)
        return vec3(s, 1.0, t);
    if (face == 3)
        return vec3(s, -1.0, -t);
    if (face == 4)
        return vec3(s, -t, 1.0);
    return vec3(-s, -t, -1.0);
}

// The point at which a direction of any length but 0 meets the cube.
struct CubePlace {
    Real face;
    Real s;
    Real t;
};

// The inverse of direction_from_cube. On an edge of the cube, X goes before Y before Z. Witness: round trip.
CubePlace cube_from_direction(vec3 d)
{
    Real ax = abs(d.x);
    Real ay = abs(d.y);
    Real az = abs(d.z);
    Mask x_major = ax >= ay && ax >= az;
    Mask y_major = !x_major && ay >= az;
    Real axis = select(x_major, d.x, select(y_major, d.y, d.z));
    // Coordinates whose sign changes with the axis are divided by it, the others by its absolute value.
    Real turned = 1.0 / select(abs(axis) > 1.0e-30, axis, 1.0e-30);
    Real straight = abs(turned);
    Real s = select(x_major, -d.z, d.x) * select(y_major, straight, turned);
    Real t = select(y_major, d.z, -d.y) * select(y_major, turned, straight);
    Real first = select(x_major, 0.0, select(y_major, 2.0, 4.0));
    CubePlace p = {select(axis < 0.0, first + 1.0, first), s, t};
    return p;
}

// Solid angle between the face's centre and the corner (s, t) of a cube face, signed, in steradians; texels and
// faces are sums of four. [Driscoll 2012, "Cubemap texel solid angle"] Witness: six faces are 4 pi; quadrature.
Real cube_corner_solid_angle(Real s, Real t) { return atan(s * t, sqrt(s * s + t * t + 1.0)); }
