// The witnesses: the published listing, quadrature over its patches, and finite differences.
#include "scene/builtin/teapot.h"
#include "tests/scene/newell.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <vector>

namespace lambent::scene {
namespace {

using test::newell_patches;
using test::newell_points;

glm::dvec3 published(std::size_t patch, std::size_t row, std::size_t column)
{
    const auto& p = newell_points[static_cast<std::size_t>(newell_patches[patch][row * 4 + column] - 1)];
    return {p[0], p[1], p[2]};
}

// De Casteljau's construction on the published points: nothing in common with the code under test.
glm::dvec3 between(std::vector<glm::dvec3> points, double t)
{
    while (points.size() > 1) {
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            points[i] = points[i] * (1.0 - t) + points[i + 1] * t;
        points.pop_back();
    }
    return points.front();
}

glm::dvec3 published_surface(std::size_t patch, double u, double v)
{
    std::vector<glm::dvec3> rows;
    for (std::size_t row = 0; row < 4; ++row)
        rows.push_back(between({published(patch, row, 0), published(patch, row, 1), published(patch, row, 2),
                                published(patch, row, 3)},
                               u));
    return between(rows, v);
}

TEST(Teapot, ControlPointsAreThePublishedOnes)
{
    const auto patches = teapot_patches();
    for (std::size_t patch = 0; patch < 28; ++patch)
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t column = 0; column < 4; ++column)
                EXPECT_LT(glm::length(patches[patch][row][column] - published(patch, row, column)), 1e-12)
                    << patch << " " << row << " " << column;
}

TEST(Teapot, TheBottomIsThePublishedOneRunBackwards)
{
    const auto patches = teapot_patches();
    for (std::size_t patch = 28; patch < 32; ++patch)
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t column = 0; column < 4; ++column)
                EXPECT_LT(
                    glm::length(patches[patch][row][column] - published(59 - patch, 3 - row, 3 - column)),
                    1e-12)
                    << patch << " " << row << " " << column;
}

// Point on an edge of a patch: 0 row 0, 1 row 3, 2 column 0, 3 column 3, as a sorted set of control points.
std::set<std::tuple<double, double, double>> edge_points(const BezierPatch& patch, int edge)
{
    std::set<std::tuple<double, double, double>> points;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec3& p = edge == 0   ? patch[0][i]
                              : edge == 1 ? patch[3][i]
                              : edge == 2 ? patch[i][0]
                                          : patch[i][3];
        points.insert({p.x + 0.0, p.y + 0.0, p.z + 0.0});
    }
    return points;
}

TEST(Teapot, NeighboursShareTheirBoundaryCurves)
{
    const auto patches = teapot_patches();
    std::map<std::set<std::tuple<double, double, double>>, int> uses;
    for (const BezierPatch& patch : patches)
        for (int edge = 0; edge < 4; ++edge)
            ++uses[edge_points(patch, edge)];
    int open = 0;
    for (const auto& [points, count] : uses) {
        if (points.size() == 1)
            continue; // the tip of the knob and the middle of the bottom
        EXPECT_LE(count, 2);
        open += count == 1 ? 1 : 0;
    }
    // Open on purpose: the inner edge of the rim (4), the edge of the lid (4), both ends of handle and spout
    // (2 each).
    EXPECT_EQ(open, 4 + 4 + 4 + 4);
}

TEST(Teapot, TrianglesOfSharedCurvesMeetVertexByVertex)
{
    constexpr int n = 6;
    const Mesh mesh = make_teapot(n);
    std::set<std::tuple<float, float, float>> distinct;
    for (const glm::vec3& p : mesh.positions) {
        constexpr float grid = 1e6f; // micrometres
        distinct.insert(
            {std::round(p.x * grid) + 0.0f, std::round(p.y * grid) + 0.0f, std::round(p.z * grid) + 0.0f});
    }
    // Rings of 4n vertices: 3n + 1 of rim and body, n less the centre of the bottom, 2n + 1 less the tip of
    // knob and lid. Tubes: 2n around, 2n + 1 along. Only the foot of the handle shares a vertex with the
    // body, at (-2, 0, 0.9).
    const std::size_t rings = 4 * n * ((3 * n + 1) + (n - 1) + 2 * n) + 2;
    const std::size_t tubes = 2 * (2 * n) * (2 * n + 1);
    EXPECT_EQ(distinct.size(), rings + tubes - 1);
}

TEST(Teapot, CountsAndSizeAreAsPromised)
{
    for (const int n : {1, 2, 7}) {
        const Mesh mesh = make_teapot(n);
        EXPECT_EQ(mesh.triangles.size(), static_cast<std::size_t>(64 * n * n - 8 * n));
        EXPECT_EQ(mesh.positions.size(), static_cast<std::size_t>(32 * (n + 1) * (n + 1)));
        EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
        EXPECT_EQ(mesh.texcoords[0].size(), mesh.positions.size());
    }
    const Mesh mesh = make_teapot(64);
    glm::vec3 low(1e9f);
    glm::vec3 high(-1e9f);
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    // In Newell's units the pot runs from the handle at -3, where its halves meet, to the lip of the spout at
    // 3.434, and is 4 wide and 3.15 tall.
    const auto unit = static_cast<float>(teapot_scale);
    EXPECT_NEAR(low.x / unit, -3.0f, 1e-3f);
    EXPECT_NEAR(high.x / unit, 3.43407f, 1e-3f);
    EXPECT_NEAR(low.y / unit, 0.0f, 1e-6f);
    EXPECT_NEAR(high.y / unit, 3.15f, 1e-3f);
    EXPECT_NEAR(low.z / unit, -2.0f, 1e-3f);
    EXPECT_NEAR(high.z / unit, 2.0f, 1e-3f);
}

TEST(Teapot, NoTriangleIsDegenerateAndAllFaceTheWayOfTheirNormals)
{
    const Mesh mesh = make_teapot(32);
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]);
        const glm::dvec3 face =
            glm::cross(glm::dvec3(mesh.positions[t.y]) - a, glm::dvec3(mesh.positions[t.z]) - a);
        EXPECT_GT(glm::length(face), 1e-9);
        for (int corner = 0; corner < 3; ++corner)
            EXPECT_GT(glm::dot(glm::normalize(face), glm::dvec3(mesh.normals[t[corner]])), 0.5);
    }
}

TEST(Teapot, NormalsAgreeWithFiniteDifferences)
{
    constexpr int n = 8;
    const Mesh mesh = make_teapot(n);
    constexpr double step = 1e-5;
    for (std::size_t patch = 0; patch < 28; ++patch) {
        for (int row = 1; row < n; ++row) {
            for (int column = 0; column <= n; ++column) {
                const double u = static_cast<double>(column) / n;
                const double v = static_cast<double>(row) / n;
                const glm::dvec3 along_u =
                    published_surface(patch, u + step, v) - published_surface(patch, u - step, v);
                const glm::dvec3 along_v =
                    published_surface(patch, u, v + step) - published_surface(patch, u, v - step);
                const glm::dvec3 z_up = glm::normalize(glm::cross(along_u, along_v));
                const glm::vec3 expected(z_up.x, z_up.z, -z_up.y);
                const std::size_t vertex =
                    patch * (n + 1) * (n + 1) + static_cast<std::size_t>(row * (n + 1) + column);
                EXPECT_LT(glm::length(mesh.normals[vertex] - expected), 1e-5f)
                    << patch << " " << row << " " << column;
            }
        }
    }
}

TEST(Teapot, NormalsAtTheTipAndTheBottomAreVertical)
{
    constexpr std::size_t n = 4;
    const Mesh mesh = make_teapot(n);
    for (std::size_t column = 0; column <= n; ++column) {
        for (std::size_t quarter = 0; quarter < 4; ++quarter) {
            const std::size_t tip = (20 + quarter) * (n + 1) * (n + 1) + column;
            EXPECT_NEAR(mesh.normals[tip].y, 1.0f, 1e-6f);
            const std::size_t centre = (28 + quarter) * (n + 1) * (n + 1) + n * (n + 1) + column;
            EXPECT_EQ(mesh.positions[centre], glm::vec3(0));
            EXPECT_NEAR(mesh.normals[centre].y, -1.0f, 1e-6f);
        }
    }
}

// Gauss-Legendre, five points on [0, 1]. [Abramowitz and Stegun, 25.4.30]
constexpr std::array<std::array<double, 2>, 5> gauss = {
    {{0.5 - 0.5 * 0.906179845938664, 0.5 * 0.236926885056189},
     {0.5 - 0.5 * 0.538469310105683, 0.5 * 0.478628670499366},
     {0.5, 0.5 * 0.568888888888889},
     {0.5 + 0.5 * 0.538469310105683, 0.5 * 0.478628670499366},
     {0.5 + 0.5 * 0.906179845938664, 0.5 * 0.236926885056189}}};

struct Integrals {
    double area = 0.0;
    double flux = 0.0; // of position / 3: the volume, where the surface is closed
};

Integrals quadrature()
{
    constexpr int cells = 8;
    constexpr double step = 1e-5;
    Integrals sum;
    for (std::size_t patch = 0; patch < 32; ++patch) {
        for (int cell = 0; cell < cells * cells; ++cell) {
            for (const auto& [x, weight_x] : gauss) {
                for (const auto& [y, weight_y] : gauss) {
                    const double u = (cell % cells + x) / cells;
                    const int row = cell / cells;
                    const double v = (row + y) / cells;
                    const glm::dvec3 du =
                        (published_surface(patch, u + step, v) - published_surface(patch, u - step, v)) /
                        (2.0 * step);
                    const glm::dvec3 dv =
                        (published_surface(patch, u, v + step) - published_surface(patch, u, v - step)) /
                        (2.0 * step);
                    const glm::dvec3 element = glm::cross(du, dv) * (weight_x * weight_y / (cells * cells));
                    sum.area += glm::length(element);
                    sum.flux += glm::dot(element, published_surface(patch, u, v)) / 3.0;
                }
            }
        }
    }
    return sum;
}

TEST(Teapot, AreaAndVolumeAgreeWithQuadrature)
{
    const Mesh mesh = make_teapot(32);
    Integrals of_mesh;
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]);
        const glm::dvec3 element =
            0.5 * glm::cross(glm::dvec3(mesh.positions[t.y]) - a, glm::dvec3(mesh.positions[t.z]) - a);
        of_mesh.area += glm::length(element);
        of_mesh.flux += glm::dot(element, a) / 3.0;
    }
    const Integrals exact = quadrature();
    EXPECT_GT(exact.flux, 0.0) << "the outside is outside";
    EXPECT_NEAR(of_mesh.area / (teapot_scale * teapot_scale), exact.area, 2e-3 * exact.area);
    EXPECT_NEAR(of_mesh.flux / (teapot_scale * teapot_scale * teapot_scale), exact.flux, 2e-3 * exact.flux);
}

} // namespace
} // namespace lambent::scene
