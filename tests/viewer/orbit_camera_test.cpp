// Moves of the eye and its limits; the size of pictures that move.
#include "apps/viewer/orbit_camera.h"
#include "apps/viewer/pace.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lambent::viewer {
namespace {

const OrbitCamera::World world{{glm::vec3(-1.0f, 0.0f, -1.0f), glm::vec3(1.0f, 2.0f, 1.0f)}, 4.0};
const double radius = std::sqrt(3.0);
constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(OrbitCamera, FramesTheSceneUntilItMoves)
{
    OrbitCamera eye(30.0, 20.0);
    EXPECT_EQ(eye.options(), (std::vector<std::string>{"--camera", "30,20"}));
    eye.orbit(10.0, -5.0);
    EXPECT_EQ(eye.options(), (std::vector<std::string>{"--camera", "40,15"}));
    eye.dolly(world, 0.0);
    EXPECT_EQ(eye.options(), (std::vector<std::string>{"--camera", "40,15,4", "--target", "0,1,0"}));
}

TEST(OrbitCamera, GoesRoundButNotOverThePoles)
{
    OrbitCamera eye(170.0, 0.0);
    eye.orbit(20.0, 100.0);
    EXPECT_NEAR(eye.azimuth(), -170.0, 1e-9);
    EXPECT_EQ(eye.elevation(), 90.0);
    eye.orbit(0.0, -1000.0);
    EXPECT_EQ(eye.elevation(), -90.0);
}

TEST(OrbitCamera, KeepsItsDistance)
{
    OrbitCamera eye;
    for (int i = 0; i < 100; ++i)
        eye.dolly(world, -5.0);
    EXPECT_NEAR(eye.distance(world), EyeLimits::nearest * radius, 1e-9);
    for (int i = 0; i < 100; ++i)
        eye.dolly(world, 5.0);
    EXPECT_NEAR(eye.distance(world), EyeLimits::farthest * radius, 1e-6);
}

TEST(OrbitCamera, PansWithTheHandAndNotOutOfTheWorld)
{
    OrbitCamera eye;
    // A whole height of the picture at the target's depth: 2 tan(45 degrees) 4 m. What is seen follows the hand, so
    // the target goes the other way.
    eye.pan(world, 1.0, 0.0, 90.0);
    EXPECT_NEAR(glm::distance(eye.target(world), glm::dvec3(-8.0, 1.0, 0.0)), 0.0, 1e-9);
    eye.pan(world, -1.0, 0.5, 90.0);
    EXPECT_NEAR(glm::distance(eye.target(world), glm::dvec3(0.0, -3.0, 0.0)), 0.0, 1e-9);
    for (int i = 0; i < 100; ++i)
        eye.pan(world, -10.0, 10.0, 90.0);
    EXPECT_NEAR(eye.target(world).x, EyeLimits::target * radius, 1e-6);
}

TEST(OrbitCamera, IsNotMovedByNumbersThatAreNone)
{
    OrbitCamera eye(1.0, 2.0);
    for (const double amount : {infinite, -infinite, std::nan("")}) {
        eye.orbit(amount, amount);
        eye.dolly(world, amount);
        eye.pan(world, amount, amount, 45.0);
    }
    EXPECT_EQ(eye.options(), (std::vector<std::string>{"--camera", "1,2,4", "--target", "0,1,0"}));
}

TEST(OrbitCamera, LooksAtWhatIsPicked)
{
    OrbitCamera eye;
    eye.look_at(world, {0.5, 0.25, 0.125});
    EXPECT_EQ(eye.target(world), glm::dvec3(0.5, 0.25, 0.125));
    EXPECT_EQ(eye.distance(world), 4.0);
}

// A scene of the world's size, seen from near: its target is said to a millionth of the distance.
TEST(OrbitCamera, KeepsItsDigitsFarFromTheOrigin)
{
    OrbitCamera::World far = world;
    far.origin = {4.5e6, 0.0, -1e8};
    OrbitCamera eye(10.0, 20.0);
    eye.look_at(far, far.origin + glm::dvec3(0.25, 1.5, 0.125));
    EXPECT_EQ(eye.options(),
              (std::vector<std::string>{"--camera", "10,20,4", "--target", "4500000.25,1.5,-99999999.875"}));
    EXPECT_EQ(OrbitCamera(0.0, 0.0).target(far), far.origin + middle_of(far.bounds));
}

TEST(OrbitCamera, AnEmptySceneIsASmallWorld)
{
    EXPECT_EQ(radius_of({}), 1.0);
    EXPECT_EQ(middle_of({}), glm::dvec3(0.0));
    EXPECT_GT(radius_of({glm::vec3(1.0f), glm::vec3(1.0f)}), 0.0);
}

// Draws with a cost of so many milliseconds for a whole picture until the scale stays.
double settled(Pace& pace, double full_ms)
{
    for (int i = 0; i < 60; ++i)
        pace.made(pace.scale(), full_ms * pace.scale() * pace.scale());
    return pace.scale();
}

TEST(Pace, IsWholeWhereTimeSuffices)
{
    Pace pace;
    EXPECT_EQ(settled(pace, 5.0), 1.0);
}

TEST(Pace, HoldsTheTargetWithoutWaste)
{
    for (const double full_ms : {40.0, 90.0, 250.0}) {
        Pace pace;
        const double scale = settled(pace, full_ms), cost = full_ms * scale * scale;
        EXPECT_LE(cost, Pace::target_ms) << full_ms;
        EXPECT_GE(cost, 0.5 * Pace::target_ms) << full_ms;
    }
}

TEST(Pace, IsSlowOnlyForAMoment)
{
    Pace pace;
    settled(pace, 20.0);
    int late = 0;
    for (int i = 0; i < 20; ++i) {
        const double cost = 200.0 * pace.scale() * pace.scale();
        late += cost > Pace::target_ms ? 1 : 0;
        pace.made(pace.scale(), cost);
    }
    EXPECT_LE(late, 4);
}

TEST(Pace, HasAFloorAndForgets)
{
    Pace pace;
    EXPECT_EQ(settled(pace, 1.0e6), Pace::least);
    EXPECT_EQ(settled(pace, 10.0), 1.0);
    pace.made(1.0, 0.0);
    pace.made(0.0, 10.0);
    pace.made(1.0, std::nan(""));
    EXPECT_EQ(pace.scale(), 1.0);
}

} // namespace
} // namespace lambent::viewer
