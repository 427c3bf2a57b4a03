#include "tests/equations/directions.h"
#include "tests/equations/quadrature.h"

#include <gtest/gtest.h>

namespace lambent::test {
namespace {

using in_double::cube_corner_solid_angle;
using in_double::direction_from_cube;
using in_double::direction_from_equirectangular;
using in_double::equirectangular_from_direction;

TEST(Equirectangular, SixAxes)
{
    struct Axis {
        vec3 direction;
        double u, v;
    };
    for (const Axis& axis :
         {Axis{{1, 0, 0}, 0.5, 0.5}, Axis{{0, 0, 1}, 0.75, 0.5}, Axis{{0, 0, -1}, 0.25, 0.5}}) {
        const vec2 uv = equirectangular_from_direction(axis.direction);
        EXPECT_NEAR(uv.x, axis.u, 1e-15);
        EXPECT_NEAR(uv.y, axis.v, 1e-15);
        EXPECT_LT(distance(direction_from_equirectangular(vec2(axis.u, axis.v)), axis.direction), 1e-15);
    }
    const double seam = equirectangular_from_direction(vec3(-1, 0, 0)).x; // both edges of the picture are -X
    EXPECT_NEAR(std::abs(seam - 0.5), 0.5, 1e-15);
    EXPECT_NEAR(equirectangular_from_direction(vec3(0, 1, 0)).y, 0.0, 1e-15);
    EXPECT_NEAR(equirectangular_from_direction(vec3(0, -1, 0)).y, 1.0, 1e-15);
    for (double edge : {0.0, 1.0})
        EXPECT_LT(distance(direction_from_equirectangular(vec2(edge, 0.5)), vec3(-1, 0, 0)), 1e-15);
}

TEST(Equirectangular, PolesHaveFiniteCoordinates)
{
    for (double y : {-1.0, 1.0}) {
        const vec2 uv = equirectangular_from_direction(vec3(0, y, 0));
        EXPECT_TRUE(uv.x >= 0.0 && uv.x <= 1.0);
    }
}

TEST(Equirectangular, RoundTrip)
{
    Uniform uniform(1);
    for (int i = 0; i < 10000; i++) {
        const vec3 d = random_direction(uniform);
        EXPECT_LT(distance(direction_from_equirectangular(equirectangular_from_direction(d)), d), 1e-12);
    }
}

TEST(Equirectangular, EqualStepsAreEqualAngles)
{
    // A step of one degree along a meridian and along the equator.
    const double step = pi / 180.0;
    const vec3 a = direction_from_equirectangular(vec2(0.3, 0.2));
    const vec3 b = direction_from_equirectangular(vec2(0.3, 0.2 + 1.0 / 180.0));
    EXPECT_NEAR(std::acos(cosine_between(a, b)), step, 1e-12);
    const vec3 c = direction_from_equirectangular(vec2(0.3, 0.5));
    const vec3 d = direction_from_equirectangular(vec2(0.3 + 1.0 / 360.0, 0.5));
    EXPECT_NEAR(std::acos(cosine_between(c, d)), step, 1e-12);
}

// Vulkan's table of cube faces, read backwards: for the axis of largest magnitude, sc, tc and ma.
TEST(Cube, FacesAreVulkansTable)
{
    for (int face = 0; face < 6; face++)
        for (double s : {-0.75, 0.0, 0.5})
            for (double t : {-0.5, 0.25}) {
                const vec3 d = direction_from_cube(face, s, t);
                const double ma[] = {d.x, -d.x, d.y, -d.y, d.z, -d.z};
                const double sc[] = {-d.z, d.z, d.x, d.x, d.x, -d.x};
                const double tc[] = {-d.y, -d.y, d.z, -d.z, -d.y, -d.y};
                EXPECT_EQ(ma[face], 1.0);
                EXPECT_EQ(sc[face], s);
                EXPECT_EQ(tc[face], t);
            }
}

// Faces and places of directions drawn by hand from Vulkan's table, of other lengths than 1, and a round trip.
TEST(Cube, PlacesAreTheInverse)
{
    struct Case {
        vec3 d;
        double face, s, t;
    };
    for (const Case& c : {Case{{2, -1, 0.5}, 0, -0.25, 0.5}, Case{{-4, 1, 2}, 1, 0.5, -0.25},
                          Case{{1, 2, -1}, 2, 0.5, -0.5}, Case{{1, -2, -1}, 3, 0.5, 0.5},
                          Case{{1, 1, 4}, 4, 0.25, -0.25}, Case{{1, 1, -4}, 5, -0.25, -0.25}}) {
        const in_double::CubePlace p = in_double::cube_from_direction(c.d);
        EXPECT_EQ(p.face, c.face);
        EXPECT_DOUBLE_EQ(p.s, c.s);
        EXPECT_DOUBLE_EQ(p.t, c.t);
    }
    for (int face = 0; face < 6; face++)
        for (double s : {-0.9, -0.1, 0.7})
            for (double t : {-0.8, 0.3, 0.95}) {
                const in_double::CubePlace p =
                    in_double::cube_from_direction(3.0 * direction_from_cube(face, s, t));
                EXPECT_EQ(p.face, face);
                EXPECT_NEAR(p.s, s, 1e-15);
                EXPECT_NEAR(p.t, t, 1e-15);
            }
}

TEST(Cube, CentresAreTheSixAxes)
{
    const vec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int face = 0; face < 6; face++)
        EXPECT_EQ(distance(direction_from_cube(face, 0.0, 0.0), axes[face]), 0.0);
}

double texel_solid_angle(double s0, double s1, double t0, double t1)
{
    return cube_corner_solid_angle(s1, t1) - cube_corner_solid_angle(s0, t1) -
           cube_corner_solid_angle(s1, t0) + cube_corner_solid_angle(s0, t0);
}

TEST(Cube, SolidAngleOfATexelByQuadrature)
{
    // A small area at (s, t, 1) is seen under cos / r^2 = (1 + s^2 + t^2)^(-3/2).
    const double edges[] = {-1.0, -0.6, 0.1, 0.15, 1.0, 2.5};
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 5; j++) {
            const auto row = [&](double t) {
                const auto area = [&](double s) { return std::pow(1.0 + s * s + t * t, -1.5); };
                return integrate(area, edges[i], edges[i + 1], 1e-13);
            };
            const double expected = integrate(row, edges[j], edges[j + 1], 1e-13);
            EXPECT_NEAR(texel_solid_angle(edges[i], edges[i + 1], edges[j], edges[j + 1]), expected, 1e-11);
        }
}

TEST(Cube, SixFacesAreTheSphere)
{
    EXPECT_NEAR(6.0 * texel_solid_angle(-1.0, 1.0, -1.0, 1.0), 4.0 * pi, 1e-13);
    constexpr int size = 32;
    double sum = 0.0;
    for (int i = 0; i < size; i++)
        for (int j = 0; j < size; j++)
            sum += texel_solid_angle(2.0 * i / size - 1.0, 2.0 * (i + 1) / size - 1.0, 2.0 * j / size - 1.0,
                                     2.0 * (j + 1) / size - 1.0);
    EXPECT_NEAR(6.0 * sum, 4.0 * pi, 1e-11);
}

} // namespace
} // namespace lambent::test
