#include "tests/equations/directions.h"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

namespace lambent::test {
namespace {

using in_double::carried_frame;
using in_double::facing_normal;
using in_double::in_frame;
using in_double::mirrored;
using in_double::orthonormal_frame;

// The axes, their diagonals, both sides of the crossing at z = 0 and of the pole, and 2000 random directions.
std::vector<vec3> all_sorts_of_directions()
{
    std::vector<vec3> directions;
    for (int x = -1; x <= 1; x++)
        for (int y = -1; y <= 1; y++)
            for (int z = -1; z <= 1; z++)
                if (const double length = std::sqrt(x * x + y * y + z * z); length > 0)
                    directions.push_back({x / length, y / length, z / length});
    for (double tiny : {1e-3, 1e-8, 1e-300})
        for (double sign : {-1.0, 1.0}) {
            const double rest = std::sqrt(1.0 - tiny * tiny);
            directions.push_back({0.6 * rest, 0.8 * rest, sign * tiny});
            directions.push_back({tiny, 0.0, sign * rest});
        }
    Uniform uniform(1);
    for (int i = 0; i < 2000; i++)
        directions.push_back(random_direction(uniform));
    return directions;
}

TEST(Frame, OrthonormalOverTheSphere)
{
    for (vec3 N : all_sorts_of_directions()) {
        const mat3 frame = orthonormal_frame(N);
        EXPECT_LT(frame_error(frame), 1e-12);
        EXPECT_EQ(distance(frame.z, N), 0.0);
    }
}

TEST(Frame, CarriedFrameIsOrthonormal)
{
    Uniform uniform(2);
    for (vec3 N : all_sorts_of_directions()) {
        const vec3 V = random_direction(uniform), across = random_direction(uniform);
        if (cosine_between(N, V) < -0.99 || std::abs(cosine_between(V, across)) > 0.99)
            continue;
        const mat3 frame = carried_frame(N, V, across);
        EXPECT_LT(frame_error(frame), 1e-10);
        EXPECT_EQ(distance(frame.z, N), 0.0);
    }
}

TEST(Frame, CarriedNowhereItIsTheDirectionAcross)
{
    for (vec3 N : all_sorts_of_directions()) {
        const vec3 across = orthonormal_frame(N).x;
        EXPECT_LT(distance(carried_frame(N, N, across).x, across), 1e-12);
        // An oblique direction is made perpendicular first.
        EXPECT_LT(distance(carried_frame(N, N, in_double::normalize(across + 0.7 * N)).x, across), 1e-12);
    }
}

// Carried along a great circle, the tangent keeps its angle to the circle's plane: an axis across it stays as it is.
TEST(Frame, CarriedAlongACircleItKeepsItsAngleToIt)
{
    for (double turn : {-2.0, -0.3, 0.2, 1.5, 3.0}) {
        const vec3 V(0.0, 0.0, 1.0), N(std::sin(turn), 0.0, std::cos(turn));
        EXPECT_LT(distance(carried_frame(N, V, vec3(0.0, 1.0, 0.0)).x, vec3(0.0, 1.0, 0.0)), 1e-12);
        EXPECT_LT(
            distance(carried_frame(N, V, vec3(1.0, 0.0, 0.0)).x, vec3(std::cos(turn), 0.0, -std::sin(turn))),
            1e-12);
    }
}

// Close to V as far from it: the axis across, turned by Rodrigues' formula about what is perpendicular to both.
TEST(Frame, CarriedFrameTendsToTheDirectionAcross)
{
    Uniform uniform(8);
    for (double eps : {1e-1, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8})
        for (int i = 0; i < 200; i++) {
            const vec3 V = random_direction(uniform);
            const mat3 about = orthonormal_frame(V);
            const double phi = uniform.between(0.0, 2.0 * std::numbers::pi);
            const vec3 k = std::cos(phi) * about.x + std::sin(phi) * about.y; // the axis of the turn
            const double cosine = 1.0 - eps, sine = std::sqrt(eps * (2.0 - eps));
            const vec3 N = cosine * V + sine * in_double::cross(k, V), across = about.x;
            const mat3 frame = carried_frame(N, V, across);
            const vec3 turned = cosine * across + sine * in_double::cross(k, across) +
                                ((1.0 - cosine) * cosine_between(k, across)) * k;
            EXPECT_LT(distance(frame.x, turned), 1e-12) << eps;
            EXPECT_LT(distance(frame.x, across), 1.001 * std::sqrt(2.0 * eps)) << eps;
            EXPECT_LT(frame_error(frame), 1e-12) << eps;
        }
}

TEST(Frame, ComponentsInAFrame)
{
    Uniform uniform(6);
    for (int i = 0; i < 100; i++) {
        const mat3 frame = orthonormal_frame(random_direction(uniform));
        const vec3 v = random_direction(uniform);
        EXPECT_LT(distance(frame * in_frame(frame, v), v), 1e-14);
    }
}

TEST(Frame, MirrorImageIsCoplanarAtTheSameAngle)
{
    Uniform uniform(3);
    for (int i = 0; i < 1000; i++) {
        const vec3 N = random_direction(uniform), V = random_direction(uniform);
        const vec3 R = mirrored(N, V);
        EXPECT_NEAR(cosine_between(R, R), 1.0, 1e-14);
        EXPECT_NEAR(cosine_between(R, N), cosine_between(V, N), 1e-14);
        const double across =
            (N.y * V.z - N.z * V.y) * R.x + (N.z * V.x - N.x * V.z) * R.y + (N.x * V.y - N.y * V.x) * R.z;
        EXPECT_NEAR(across, 0.0, 1e-14);
    }
    EXPECT_LT(distance(mirrored(vec3(0, 1, 0), vec3(0.6, 0.8, 0.0)), vec3(-0.6, 0.8, 0.0)), 1e-15);
}

TEST(Frame, NormalInFrontIsReturnedUnchanged)
{
    Uniform uniform(4);
    for (int i = 0; i < 1000; i++) {
        const vec3 N = random_direction(uniform), V = random_direction(uniform);
        if (cosine_between(N, V) >= 0.05) {
            EXPECT_EQ(distance(facing_normal(N, V, 0.05), N), 0.0);
        }
    }
}

TEST(Frame, NormalBehindIsBentToFaceTheView)
{
    Uniform uniform(5);
    for (double least : {1e-4, 1e-2, 0.05, 0.09})
        for (int i = 0; i < 1000; i++) {
            const vec3 V = random_direction(uniform);
            // The last tenth look straight away from V, within 0.001 radians.
            const vec3 away = random_direction(uniform);
            const vec3 near = in_double::normalize(1e-3 * away - V);
            const vec3 N = i < 900 ? away : near;
            const vec3 bent = facing_normal(N, V, least);
            EXPECT_NEAR(cosine_between(bent, bent), 1.0, 1e-13);
            EXPECT_GE(cosine_between(bent, V), least);
        }
}

// Turned in the plane of N and V, and no further than asked but for a margin.
TEST(Frame, NormalBehindIsBentTowardsTheViewOnlyAsFarAsItMust)
{
    Uniform uniform(7);
    int bent_ones = 0;
    for (double least : {1e-4, 1e-2, 0.05, 0.09})
        for (int i = 0; i < 1000; i++) {
            const vec3 V = random_direction(uniform), N = random_direction(uniform);
            const double NV = cosine_between(N, V);
            if (NV >= least || NV < -0.5)
                continue;
            bent_ones++;
            const vec3 bent = facing_normal(N, V, least), plane = in_double::cross(N, V);
            EXPECT_NEAR(cosine_between(bent, plane), 0.0, 1e-14);
            // Between N and V, not past V: on N's side of it.
            EXPECT_GT(cosine_between(in_double::cross(bent, V), plane), 0.0);
            EXPECT_GT(cosine_between(in_double::cross(N, bent), plane), 0.0);
            EXPECT_LT(cosine_between(bent, V), 1.25 * least + 0.01);
        }
    EXPECT_GT(bent_ones, 1000);
}

} // namespace
} // namespace lambent::test
