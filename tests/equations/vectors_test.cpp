// GLSL's vectors in C++: the operations whose definition leaves room for error.
#include "equations/in_double.h"

#include <gtest/gtest.h>

namespace lambent::in_double {
namespace {

void expect_equal(vec3 a, vec3 b)
{
    EXPECT_DOUBLE_EQ(a.x, b.x);
    EXPECT_DOUBLE_EQ(a.y, b.y);
    EXPECT_DOUBLE_EQ(a.z, b.z);
}

TEST(Vectors, CrossIsRightHanded)
{
    expect_equal(cross(vec3(1, 0, 0), vec3(0, 1, 0)), vec3(0, 0, 1));
    expect_equal(cross(vec3(0, 1, 0), vec3(0, 0, 1)), vec3(1, 0, 0));
    expect_equal(cross(vec3(1, 2, 3), vec3(4, 5, 6)), vec3(-3, 6, -3));
}

TEST(Vectors, MatrixHoldsColumns)
{
    const mat3 m(vec3(1, 2, 3), vec3(10, 20, 30), vec3(100, 200, 300));
    expect_equal(m * vec3(1, 0, 0), vec3(1, 2, 3));
    expect_equal(m * vec3(1, 2, 3), vec3(321, 642, 963));
}

TEST(Vectors, Arithmetic)
{
    const vec3 a(1, 2, 4), b(3, 5, -7);
    expect_equal(a + b, vec3(4, 7, -3));
    expect_equal(a - b, vec3(-2, -3, 11));
    expect_equal(a * b, vec3(3, 10, -28));
    expect_equal(-a, vec3(-1, -2, -4));
    expect_equal(2.0 * a, vec3(2, 4, 8));
    expect_equal(a / 2.0, vec3(0.5, 1, 2));
    expect_equal(1.0 - a, vec3(0, -1, -3));
    expect_equal(min(a, b), vec3(1, 2, -7));
    expect_equal(max(a, b), vec3(3, 5, 4));
    expect_equal(clamp(b, 0.0, 4.0), vec3(3, 4, 0));
    expect_equal(select(true, a, b), a);
    expect_equal(select(false, a, b), b);
    EXPECT_EQ(dot(a, b), -15);
    EXPECT_EQ(dot(vec2(1, 2), vec2(3, 4)), 11);
}

TEST(Vectors, MixGoesFromFirstToSecond)
{
    EXPECT_EQ(mix(2.0, 6.0, 0.25), 3.0);
    expect_equal(mix(vec3(0, 1, 2), vec3(4, 5, 6), 0.25), vec3(1, 2, 3));
}

TEST(Vectors, NormalizeKeepsTheDirection)
{
    expect_equal(normalize(vec3(2, -3, 6)), vec3(2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0));
}

} // namespace
} // namespace lambent::in_double
