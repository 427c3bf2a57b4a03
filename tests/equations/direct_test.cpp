// The passes of lights without size, in double, against closed forms.
#include "tests/equations/directions.h"

#include <gtest/gtest.h>

namespace lambent::in_double {
namespace {

// Each test takes some of it.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include "shading/surface/pixel.glsl"
int stretch = 0;
int has_stretch()
{
    return stretch;
}

#include "shading/lobes/facets.glsl"
#include "shading/lobes/arrival.glsl"
#include "shading/lobes/direct.glsl"
#pragma GCC diagnostic pop

} // namespace
} // namespace lambent::in_double

namespace lambent::test {
namespace {

using in_double::alpha_in_pixel;
using in_double::Arrival;
using in_double::arrival_from;
using in_double::arrival_of;
using in_double::ShinyPoint;
using std::numbers::pi;

TEST(Lights, FarAwayLightAllPointsAlike)
{
    const in_double::LocalLight light = {
        vec3(1.0, 2.0, 5.0), vec3(27.0, 9.0, 3.0), vec3(0.0, 0.0, 1.0), 0.0, -2.0, -3.0};
    const auto far = arrival_of(light, 0, vec3(7.0, 8.0, 9.0)),
               near = arrival_of(light, 1, vec3(1.0, 2.0, 2.0));
    EXPECT_EQ(far.illuminance.x, 27.0);
    EXPECT_EQ(far.direction.z, -1.0);
    EXPECT_NEAR(near.illuminance.x, 3.0, 1e-12) << "the inverse square of three metres";
}

// Mirrored directions 0.2 apart are of normals 0.1 apart: slopes in a box of variance 0.01 / 12 along one axis, half
// of it as the mean of both. alpha^2 grows by twice that.
TEST(Direct, BendInAPixelAddsToAlpha)
{
    const vec3 none(0.0);
    EXPECT_NEAR(std::pow(alpha_in_pixel(0.1, vec3(0.2, 0.0, 0.0), none), 2.0), 0.01 + 0.04 / 48.0, 1e-15);
    EXPECT_NEAR(std::pow(alpha_in_pixel(0.1, none, vec3(0.0, 0.0, 0.2)), 2.0), 0.01 + 0.04 / 48.0, 1e-15);
    EXPECT_NEAR(std::pow(alpha_in_pixel(0.0, vec3(0.3, 0.0, 0.4), vec3(0.0, -0.5, 0.0)), 2.0), 0.5 / 48.0,
                1e-15);
    EXPECT_EQ(alpha_in_pixel(0.25, none, none), 0.25);
    EXPECT_EQ(alpha_in_pixel(0.9, vec3(9.0, 0.0, 0.0), none), 1.0);
}

TEST(Direct, ALampArrivesFromItsPlaceByTheInverseSquare)
{
    const Arrival a =
        arrival_from({vec3(1.0, 2.0, 5.0), vec3(27.0, 9.0, 0.0), vec3(0.0, 0.0, 1.0), 0.0, -2.0, -3.0},
                     vec3(0.0, 0.0, 3.0));
    EXPECT_LT(distance(a.direction, vec3(1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0)), 1e-15);
    EXPECT_LT(distance(a.illuminance, vec3(3.0, 1.0, 0.0)), 1e-14);
}

// A spot lights what lies the way its axis points: all of it inside 0.1, a quarter where the cosine is halfway.
TEST(Direct, ASpotShinesAlongItsAxis)
{
    const auto light_at = [](vec3 point) {
        return arrival_from({vec3(0.0), vec3(1.0), vec3(0.0, -1.0, 0.0), 0.0, 0.9, 0.5}, point).illuminance.x;
    };
    EXPECT_NEAR(light_at(vec3(0.0, -1.0, 0.0)), 1.0, 1e-15);
    EXPECT_NEAR(light_at(vec3(std::sqrt(1.0 - 0.49), -0.7, 0.0)), 0.25, 1e-14);
    EXPECT_EQ(light_at(vec3(0.0, 1.0, 0.0)), 0.0);
}

TEST(Direct, NothingArrivesFromBehind)
{
    const in_double::Phong phong = {vec3(1.0), vec3(1.0), 1.0};
    const in_double::Metallic metal = {vec3(1.0), 0.5, vec2(0.5), vec3(0.0), 1.0};
    const vec3 N(0.0, 0.0, 1.0), V = from_angles(0.5, 1.0);
    for (double theta : {0.5 * pi + 1e-9, 2.0, pi}) {
        const Arrival a = {from_angles(theta, 2.0), vec3(5.0)};
        EXPECT_EQ(distance(direct_phong(phong, N, V, a), vec3(0.0)), 0.0) << theta;
        EXPECT_EQ(distance(direct_metallic(metal, vec2(0.7, 0.1), N, V, a), vec3(0.0)), 0.0) << theta;
    }
}

// A surface that is looked at at 45 degrees, seen by a pixel whose mirrored directions spread over dx and dy.
ShinyPoint point_of(double across, double along)
{
    const double half = std::sqrt(0.5);
    return {vec3(0.0, 0.0, 1.0), vec3(0.0, -half, half), across * vec3(1.0, 0.0, 0.0),
            along * vec3(0.0, half, -half)};
}

vec3 at_place(const ShinyPoint& s, double x, double y)
{
    return in_double::mirrored(s.normal, s.view) + x * s.mirrored_dx + y * s.mirrored_dy;
}

// The mean of `look`, given a normal, over all of the pixel: the normal halfway from V to what is mirrored.
template <class Look>
double mean_over_pixel(const ShinyPoint& s, const Look& look)
{
    constexpr int steps = 128;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const vec3 R = at_place(s, (i + 0.5) / steps - 0.5, (j + 0.5) / steps - 0.5);
            const vec3 both = R + s.view;
            sum += look((1.0 / std::hypot(both.x, both.y, both.z)) * both);
        }
    return sum / (steps * steps);
}

// Highlights from a third of a pixel up to one pixel's width, in the middle, in a corner, and outside.
TEST(Direct, APixelSeesTheMeanOfANarrowHighlight)
{
    for (double exponent : {2000.0, 20000.0})
        for (double width : {1.5, 4.0, 8.0})
            for (double off : {0.0, 0.3, 0.45, 0.7}) {
                const double alpha = std::sqrt(2.0 / (exponent + 2.0));
                const ShinyPoint s = point_of(width * alpha, 0.7 * width * alpha);
                const Arrival a = {in_double::normalize(at_place(s, off, -off)), vec3(1.0)};
                const in_double::Phong p = {vec3(0.3), vec3(0.9), exponent};
                const in_double::Metallic m = {vec3(0.9), 1.0, vec2(alpha), vec3(0.0), 0.0};
                const vec2 albedo(0.8, 0.1);
                const Arrival ahead = {at_place(s, 0.0, 0.0), vec3(1.0)};
                const double all =
                    mean_over_pixel(s, [&](vec3 N) { return direct_phong(p, N, s.view, ahead).x; });
                const double phong =
                    mean_over_pixel(s, [&](vec3 N) { return direct_phong(p, N, s.view, a).x; });
                const double metal =
                    mean_over_pixel(s, [&](vec3 N) { return direct_metallic(m, albedo, N, s.view, a).x; });
                EXPECT_NEAR(direct_phong_in_pixel(p, s, a).x, phong, 0.04 * all)
                    << exponent << ' ' << width << ' ' << off;
                EXPECT_NEAR(direct_metallic_in_pixel(m, albedo, s, a).x, metal, 0.04 * all)
                    << exponent << ' ' << width << ' ' << off;
            }
}

// 64 looks spread as the pixel does: their middle, and a twelfth of its area along each side, but for 1/64 of that, which
// is of a look.
TEST(Direct, LooksAreSpreadOverThePixel)
{
    const ShinyPoint s = point_of(0.01, 0.02);
    const vec3 R = in_double::mirrored(s.normal, s.view);
    double x = 0.0, y = 0.0, xx = 0.0, yy = 0.0;
    for (int i = 0; i < 64; ++i) {
        const vec3 off = in_double::mirrored(in_double::normal_of_look(s, i), s.view) - R;
        const double u = dot(off, s.mirrored_dx) / 1e-4, v = dot(off, s.mirrored_dy) / 4e-4;
        x += u / 64.0, y += v / 64.0, xx += u * u / 64.0, yy += v * v / 64.0;
    }
    EXPECT_NEAR(x, 0.0, 1e-3);
    EXPECT_NEAR(y, 0.0, 1e-3);
    EXPECT_NEAR(xx, 63.0 / 64.0 / 12.0, 1e-3);
    EXPECT_NEAR(yy, 63.0 / 64.0 / 12.0, 1e-3);
}

// At a rim a pixel's mirrored directions would go on behind the surface: looks stay on its side, and see the viewer.
TEST(Direct, LooksAtARimStayOnTheSurfacesSide)
{
    for (double NV : {0.3, 0.05, 0.001}) {
        const double sine = std::sqrt(1.0 - NV * NV);
        const ShinyPoint s = {vec3(0.0, 0.0, 1.0), vec3(0.0, -sine, NV), vec3(0.1 * NV, 0.0, 0.0),
                              vec3(0.0, -NV, sine)};
        for (int i = 0; i < 64; ++i) {
            const vec3 N = in_double::normal_of_look(s, i);
            EXPECT_GT(dot(N, s.view), 0.0) << NV << ' ' << i;
            EXPECT_GT(N.z, 0.7) << NV << ' ' << i;
        }
    }
}

// More looks where the turn, of both sides together, is wider than alpha, and the light no farther off than it and 6 alpha.
TEST(Direct, ManyLooksAreForNarrowHighlightsInReach)
{
    const auto hides = [](double turn, double alpha, double off) {
        const ShinyPoint s = point_of(turn, 0.0);
        const vec3 L = in_double::normalize(in_double::mirrored(s.normal, s.view) + vec3(off, 0.0, 0.0));
        return in_double::hides_highlight(s, vec2(alpha), L);
    };
    EXPECT_TRUE(hides(0.0101, 0.01, 0.0));
    EXPECT_FALSE(hides(0.0099, 0.01, 0.0));
    EXPECT_TRUE(hides(0.02, 0.01, 0.079));
    EXPECT_FALSE(hides(0.02, 0.01, 0.081));
}

} // namespace
} // namespace lambent::test
