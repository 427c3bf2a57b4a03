// Directions for tests: made from angles and random numbers, not by the equations.
#pragma once

#include "equations/in_double.h"
#include "tests/equations/uniform.h"

#include <array>
#include <numbers>

namespace lambent::test {

using in_double::mat3;
using in_double::vec2;
using in_double::vec3;

// theta from +z, phi from +x towards +y, in radians.
inline vec3 from_angles(double theta, double phi)
{
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

// Uniform over the sphere.
inline vec3 random_direction(Uniform& uniform)
{
    const double z = uniform.between(-1.0, 1.0), phi = uniform.between(0.0, 2.0 * std::numbers::pi);
    const double r = std::sqrt(1.0 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
}

inline std::array<double, 3> components(vec3 a)
{
    return {a.x, a.y, a.z};
}

inline double cosine_between(vec3 a, vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline double distance(vec3 a, vec3 b)
{
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

// Largest departure of the columns from a right-handed orthonormal frame.
inline double frame_error(const mat3& m)
{
    const vec3 &a = m.x, &b = m.y, &c = m.z;
    const double determinant =
        a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) + a.z * (b.x * c.y - b.y * c.x);
    double worst = std::abs(determinant - 1.0);
    for (double e : {cosine_between(a, a) - 1.0, cosine_between(b, b) - 1.0, cosine_between(c, c) - 1.0,
                     cosine_between(a, b), cosine_between(b, c), cosine_between(c, a)})
        worst = std::max(worst, std::abs(e));
    return worst;
}

} // namespace lambent::test
