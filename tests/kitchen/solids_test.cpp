// The solids against their closed forms.
#include "kitchen/model/solids.h"

#include <gtest/gtest.h>

#include <glm/ext/vector_double3.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace lambent::kitchen {
namespace {

constexpr double pi = std::numbers::pi;

// Of a closed mesh that faces outwards. [the divergence theorem]
double volume(const scene::Mesh& mesh)
{
    double sum = 0.0;
    for (const glm::uvec3 t : mesh.triangles)
        sum += glm::dot(glm::dvec3(mesh.positions[t.x]),
                        glm::cross(glm::dvec3(mesh.positions[t.y]), glm::dvec3(mesh.positions[t.z]))) /
               6.0;
    return sum;
}

// By position, to a hundredth of a millimetre, every edge is walked as often in each direction.
bool is_closed(const scene::Mesh& mesh)
{
    using Point = std::tuple<long, long, long>;
    const auto point = [&](std::uint32_t i) {
        const glm::vec3 p = mesh.positions[i];
        return Point(std::lround(p.x * 1e5f), std::lround(p.y * 1e5f), std::lround(p.z * 1e5f));
    };
    std::map<std::pair<Point, Point>, int> edges;
    for (const glm::uvec3 t : mesh.triangles)
        for (int i = 0; i < 3; ++i) {
            ++edges[{point(t[i]), point(t[(i + 1) % 3])}];
            --edges[{point(t[(i + 1) % 3]), point(t[i])}];
        }
    for (const auto& [edge, balance] : edges)
        if (balance != 0)
            return false;
    return true;
}

TEST(Box, SharpBoxIsExact)
{
    const scene::Mesh mesh = make_box({{-1.0f, 0.0f, 2.0f}, {1.0f, 3.0f, 2.5f}});
    EXPECT_EQ(mesh.triangles.size(), 12u);
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_NEAR(volume(mesh), 3.0, 1e-6);
}

TEST(Box, RoundedBoxApproachesItsVolume)
{
    // An inner box, six slabs, twelve quarter cylinders and eight octants of a sphere. [Steiner's formula]
    const double a = 0.8, b = 1.8, c = 0.6, r = 0.1;
    const double exact =
        a * b * c + 2.0 * r * (a * b + b * c + c * a) + pi * r * r * (a + b + c) + 4.0 / 3.0 * pi * r * r * r;
    BoxShape shape{{0.0f, 0.0f, 0.0f}, {1.0f, 2.0f, 0.8f}, 0.1f};
    shape.steps = 16;
    const scene::Mesh mesh = make_box(shape);
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_NEAR(volume(mesh), exact, 1e-4 * exact);
    shape.steps = 1;
    EXPECT_TRUE(is_closed(make_box(shape)));
}

TEST(Box, GrainRunsWhereItIsAsked)
{
    BoxShape shape{{0.0f, 0.0f, 0.0f}, {1.0f, 2.0f, 3.0f}};
    for (int grain = 0; grain < 3; ++grain) {
        shape.grain = grain;
        const scene::Mesh mesh = make_box(shape);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            if (mesh.normals[i][grain] == 0.0f) {
                EXPECT_EQ(mesh.texcoords[0][i].y, mesh.positions[i][grain]);
            }
    }
}

TEST(Lathe, ConeHasItsVolume)
{
    const scene::Mesh mesh = make_lathe({{{0.0f, 0.0f}, {0.5f, 0.0f}, {0.2f, 1.0f}, {0.0f, 1.0f}}, 256});
    EXPECT_TRUE(is_closed(mesh));
    const double exact = pi / 3.0 * (0.25 + 0.1 + 0.04);
    EXPECT_NEAR(volume(mesh), exact, 3e-4 * exact);
}

TEST(Lathe, SmoothProfileHasNormalsOfTheSphere)
{
    std::vector<glm::vec2> profile;
    for (int i = 0; i <= 64; ++i) {
        const double angle = pi * i / 64.0;
        profile.push_back(
            {static_cast<float>(i % 64 == 0 ? 0.0 : std::sin(angle)), static_cast<float>(-std::cos(angle))});
    }
    const scene::Mesh mesh = make_lathe({profile, 128});
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_NEAR(volume(mesh), 4.0 / 3.0 * pi, 0.006);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        EXPECT_NEAR(glm::length(mesh.positions[i] - mesh.normals[i]), 0.0f, 2e-3f);
}

TEST(Tube, TorusPieceHasPappussVolume)
{
    std::vector<glm::vec3> path;
    for (int i = 0; i <= 200; ++i) {
        const double angle = 0.5 * pi * i / 200.0;
        path.push_back({static_cast<float>(std::cos(angle)), 0.0f, static_cast<float>(std::sin(angle))});
    }
    const scene::Mesh mesh = make_tube({path, {0.1f}, 64});
    EXPECT_TRUE(is_closed(mesh));
    const double exact = pi * 0.01 * 0.5 * pi;
    EXPECT_NEAR(volume(mesh), exact, 3e-3 * exact);
}

TEST(Path, CornersAreRoundAndEndsStay)
{
    const glm::vec3 points[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    const std::vector<glm::vec3> path = rounded_path(points, 0.2f, 8);
    EXPECT_EQ(path.front(), points[0]);
    EXPECT_EQ(path.back(), points[2]);
    // No turn between two pieces is sharper than the arc's part of the quarter turn.
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
        const glm::vec3 before = glm::normalize(path[i] - path[i - 1]),
                        after = glm::normalize(path[i + 1] - path[i]);
        EXPECT_GT(glm::dot(before, after), std::cos(0.3f));
    }
    const std::vector<glm::vec3> curve = smooth(std::span<const glm::vec3>(points), 10);
    for (const std::size_t knot : {0u, 1u, 2u})
        EXPECT_NEAR(glm::length(curve[10 * knot] - points[knot]), 0.0f, 1e-6f);
}

} // namespace
} // namespace lambent::kitchen
