// From triangles to surfaces, in double: differentials against differences, frames against closed forms.
#include "tests/equations/directions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambent::in_double {
namespace {

#include "shading/surface/surface.glsl"

} // namespace
} // namespace lambent::in_double

namespace lambent::test {
namespace {

using namespace in_double;

constexpr double step = 1e-6; // pixels

double len(const vec3& v)
{
    return std::sqrt(dot(v, v));
}

const Triangle triangle = {vec3(-1.0, -0.8, 0.3), vec3(2.5, 0.4, -0.6), vec3(0.3, 2.2, 0.5)};

// A perspective whose neighbours also start a little apart.
SightRay sight(double x, double y)
{
    const vec3 origin_dx(0.01, 0.0, 0.0), origin_dy(0.0, 0.005, 0.0), dx(0.02, 0.0, 0.001),
        dy(0.0, -0.03, 0.0);
    return {vec3(0.1, 0.2, 4.0) + x * origin_dx + y * origin_dy, origin_dx, origin_dy,
            vec3(-0.05, 0.02, -1.3) + x * dx + y * dy,           dx,        dy};
}

Facet facet(double x, double y)
{
    return facet_at(sight(x, y), triangle, meeting_with(sight(x, y), triangle));
}

TEST(Surface, AMeetingIsFoundAgain)
{
    for (const auto& [u, v] : {std::pair(0.2, 0.3), {0.0, 0.0}, {0.7, 0.3}, {0.05, 0.9}}) {
        const vec3 point = triangle.corner + u * triangle.edge1 + v * triangle.edge2;
        SightRay s = sight(0.0, 0.0);
        s.direction = (1.0 / 2.5) * (point - s.origin);
        const Meeting m = meeting_with(s, triangle);
        EXPECT_NEAR(m.distance, 2.5, 1e-12);
        EXPECT_NEAR(m.u, u, 1e-12);
        EXPECT_NEAR(m.v, v, 1e-12);
    }
    SightRay outside = sight(0.0, 0.0);
    outside.direction = triangle.corner + 0.8 * triangle.edge1 + 0.7 * triangle.edge2 - outside.origin;
    const Meeting m = meeting_with(outside, triangle);
    EXPECT_NEAR(m.u + m.v, 1.0, 1e-12);
}

TEST(Surface, WeightsChangeAsNeighbouringRaysSay)
{
    const Barycentric at = facet(0.0, 0.0).at;
    EXPECT_NEAR(at.a + at.b + at.c, 1.0, 1e-12);
    const Barycentric right = facet(step, 0.0).at, left = facet(-step, 0.0).at, below = facet(0.0, step).at,
                      above = facet(0.0, -step).at;
    EXPECT_NEAR(at.b_dx, (right.b - left.b) / (2.0 * step), 1e-8);
    EXPECT_NEAR(at.c_dx, (right.c - left.c) / (2.0 * step), 1e-8);
    EXPECT_NEAR(at.b_dy, (below.b - above.b) / (2.0 * step), 1e-8);
    EXPECT_NEAR(at.c_dy, (below.c - above.c) / (2.0 * step), 1e-8);
}

TEST(Surface, PositionsMoveOnThePlane)
{
    const SightRay s = sight(0.0, 0.0);
    const Facet f = facet(0.0, 0.0);
    const vec3 moved = moved_on_plane(s.direction, f.normal, f.distance, s.origin_dx, s.direction_dx);
    const vec3 difference = (1.0 / (2.0 * step)) * (facet(step, 0.0).position - facet(-step, 0.0).position);
    EXPECT_LT(distance(moved, difference), 1e-8);
    EXPECT_LT(distance(f.position, s.origin + f.distance * s.direction), 1e-12);
}

TEST(Surface, OverflowingRatesAreNotBelieved)
{
    EXPECT_EQ(finite_or_zero(-9.0e14), -9.0e14);
    EXPECT_EQ(finite_or_zero(2.0e15), 0.0);
    EXPECT_EQ(finite_or_zero(std::numeric_limits<double>::infinity()), 0.0);
    EXPECT_EQ(largest_part(vec3(1.0, -7.0, 3.0)), 7.0);
}

TEST(Surface, NormalsTurnAsTheirDifferenceSays)
{
    const vec3 sum(0.5, 1.5, -0.7), dx(0.3, -0.2, 0.1), dy(0.0, 0.4, 0.4);
    const Turning t = turning_of(sum, dx, dy);
    EXPECT_NEAR(len(t.normal), 1.0, 1e-12);
    const vec3 difference = (1.0 / (2.0 * step)) * (normalize(sum + step * dx) - normalize(sum - step * dx));
    EXPECT_LT(distance(t.dx, difference), 1e-9);
    EXPECT_NEAR(dot(t.dy, t.normal), 0.0, 1e-12);
}

TEST(Surface, NormalMapsSpanTheFrame)
{
    const vec3 up(0.0, 1.0, 0.0), along(5.0, 0.0, 0.0); // of any length
    EXPECT_LT(distance(mapped_normal(up, along, 1.0, vec3(0.5, 0.5, 1.0), 1.0), up), 1e-12);
    EXPECT_LT(distance(mapped_normal(up, along, 1.0, vec3(1.0, 0.5, 0.5), 1.0), vec3(1.0, 0.0, 0.0)), 1e-12);
    // The bitangent is N x T, or the other way.
    EXPECT_LT(distance(mapped_normal(up, along, 1.0, vec3(0.5, 1.0, 0.5), 1.0), vec3(0.0, 0.0, -1.0)), 1e-12);
    EXPECT_LT(distance(mapped_normal(up, along, -1.0, vec3(0.5, 1.0, 0.5), 1.0), vec3(0.0, 0.0, 1.0)), 1e-12);
    const vec3 half = mapped_normal(up, along, 1.0, vec3(1.0, 0.5, 1.0), 0.5);
    EXPECT_NEAR(half.x / half.y, 0.5, 1e-12);
    EXPECT_LT(distance(mapped_normal(up, along, 1.0, vec3(0.5, 0.5, 0.5), 1.0), up), 1e-12); // says nothing
}

// A sphere of radius 1 about the origin: position, normal and mirrored direction through a place of the picture.
struct OnSphere {
    vec3 normal, view, mirror;
};

OnSphere on_sphere(const SightRay& s)
{
    const vec3 d = normalize(s.direction);
    const double b = dot(s.origin, d), t = -b - std::sqrt(b * b - dot(s.origin, s.origin) + 1.0);
    const vec3 p = s.origin + t * d;
    return {p, -d, mirrored(p, -d)};
}

TEST(Surface, ASphereMirrorsAsItDoes)
{
    const SightRay s = sight(3.0, 5.0);
    const OnSphere here = on_sphere(s);
    // The triangle's plane touches the sphere where it is seen; the normal is the position.
    const double t = dot(here.normal - s.origin, here.normal) / dot(s.direction, here.normal);
    const vec3 dx = moved_on_plane(s.direction, here.normal, t, s.origin_dx, s.direction_dx);
    const vec3 dy = moved_on_plane(s.direction, here.normal, t, s.origin_dy, s.direction_dy);
    const Facet f = {here.normal, 3.0 * here.normal, t, {}};
    const Surface surface = surface_at(s, f, turning_of(here.normal, dx, dy), here.normal, 1.0);
    EXPECT_LT(distance(surface.normal, here.normal), 1e-12);
    EXPECT_LT(distance(surface.view, here.view), 1e-12);
    EXPECT_NEAR(surface.depth, distance(here.normal, s.origin), 1e-12);
    const vec3 right = on_sphere(sight(3.0 + step, 5.0)).mirror,
               left = on_sphere(sight(3.0 - step, 5.0)).mirror;
    EXPECT_LT(distance(surface.mirrored_dx, (1.0 / (2.0 * step)) * (right - left)), 1e-8);
    const vec3 below = on_sphere(sight(3.0, 5.0 + step)).mirror,
               above = on_sphere(sight(3.0, 5.0 - step)).mirror;
    EXPECT_LT(distance(surface.mirrored_dy, (1.0 / (2.0 * step)) * (below - above)), 1e-8);
}

// The back of a surface is lit like a front; where a transform mirrors, the other side is the front.
TEST(Surface, BacksFaceTheViewer)
{
    const SightRay s = sight(0.0, 0.0);
    const vec3 normal = normalize(facet(0.0, 0.0).normal);
    const Turning turning = {normal, vec3(0.1, 0.0, 0.0), vec3(0.0)};
    const Facet front = facet(0.0, 0.0);
    Facet back = front;
    back.normal = -front.normal;
    const Surface seen = surface_at(s, front, turning, normal, 1.0),
                  behind = surface_at(s, back, turning, -normal, 1.0);
    EXPECT_GT(dot(seen.normal, seen.view), 0.0);
    EXPECT_LT(distance(seen.normal, normal), 1e-12);
    EXPECT_LT(distance(behind.normal, normal), 1e-12);
    // Where a transform mirrors, the clockwise side is the front.
    const Surface mirrored_front = surface_at(s, back, turning, normal, -1.0);
    EXPECT_LT(distance(mirrored_front.normal, normal), 1e-12);
}

TEST(Surface, MirroredDirectionsMoveAtMostHalfTheSky)
{
    const vec3 up(0.0, 1.0, 0.0), view = normalize(vec3(0.3, 1.0, 0.0));
    EXPECT_NEAR(len(mirrored_change(up, view, vec3(90.0, 0.0, 0.0), vec3(0.0))), 1.0, 1e-12);
}

TEST(Surface, MaterialsBecomeThoseOfTheReport)
{
    const vec3 base(0.9, 0.5, 0.1);
    const Phong metal = phong_from_metallic(base, 1.0, 0.25), plastic = phong_from_metallic(base, 0.0, 0.25);
    EXPECT_LT(len(metal.diffuse), 1e-15);
    EXPECT_LT(distance(metal.specular, base), 1e-15);
    EXPECT_LT(distance(plastic.diffuse, base), 1e-15);
    EXPECT_NEAR(plastic.specular.x, 0.04, 1e-15);
    EXPECT_NEAR(metal.exponent, 2.0 / std::pow(0.5, 4.0) - 2.0,
                1e-12); // alpha = roughness^2, exponent 2 / alpha^2 - 2
}

} // namespace
} // namespace lambent::test
