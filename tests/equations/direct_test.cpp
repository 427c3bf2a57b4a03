// The passes of lights without size, in double, against closed forms.
#include "tests/equations/directions.h"

#include <gtest/gtest.h>

namespace lambent::in_double {
namespace {

#include "shading/direct.glsl"

} // namespace
} // namespace lambent::in_double

namespace lambent::test {
namespace {

using in_double::alpha_in_pixel;
using in_double::Arrival;
using in_double::arrival_from;
using std::numbers::pi;

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
    const in_double::Metallic metal = {vec3(1.0), 0.5, 0.5, 1.0};
    const vec3 N(0.0, 0.0, 1.0), V = from_angles(0.5, 1.0);
    for (double theta : {0.5 * pi + 1e-9, 2.0, pi}) {
        const Arrival a = {from_angles(theta, 2.0), vec3(5.0)};
        EXPECT_EQ(distance(direct_phong(phong, N, V, a), vec3(0.0)), 0.0) << theta;
        EXPECT_EQ(distance(direct_metallic(metal, vec2(0.7, 0.1), N, V, a), vec3(0.0)), 0.0) << theta;
    }
}

} // namespace
} // namespace lambent::test
