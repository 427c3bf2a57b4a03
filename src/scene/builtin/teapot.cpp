#include "scene/builtin/teapot.h"

#include <glm/geometric.hpp>

#include <cstdint>
#include <span>

namespace lambent::scene {
namespace {

// The pot consists of circles around its axis: four cubic arcs, whose inner control points are `bulge` away from the
// axes (0.56 of the radius, except for one ring of the knob).
struct Ring {
    double radius;
    double height;
    double bulge;
};

constexpr Ring ring(double radius, double height)
{
    return {radius, height, 0.56 * radius};
}

constexpr std::array<Ring, 4> rim = {ring(1.4, 2.4), ring(1.3375, 2.53125), ring(1.4375, 2.53125),
                                     ring(1.5, 2.4)};
constexpr std::array<Ring, 4> upper_body = {ring(1.5, 2.4), ring(1.75, 1.875), ring(2.0, 1.35),
                                            ring(2.0, 0.9)};
constexpr std::array<Ring, 4> lower_body = {ring(2.0, 0.9), ring(2.0, 0.45), ring(1.5, 0.225),
                                            ring(1.5, 0.15)};
constexpr std::array<Ring, 4> knob = {ring(0.0, 3.15), Ring{0.8, 3.15, 0.45}, ring(0.0, 2.85),
                                      ring(0.2, 2.7)};
constexpr std::array<Ring, 4> lid = {ring(0.2, 2.7), ring(0.4, 2.55), ring(1.3, 2.55), ring(1.3, 2.4)};
constexpr std::array<Ring, 4> bottom = {ring(1.5, 0.15), ring(1.5, 0.075), ring(1.425, 0.0), ring(0.0, 0.0)};

// Handle and spout are tubes, symmetric about y = 0: half a cross-section is a cubic arc between two points in that
// plane, whose inner control points are at `half_width`.
struct Rung {
    double x1, z1;
    double x2, z2;
    double half_width;
};

constexpr std::array<Rung, 7> handle = {{{-1.6, 2.025, -1.5, 2.25, 0.3},
                                         {-2.3, 2.025, -2.5, 2.25, 0.3},
                                         {-2.7, 2.025, -3.0, 2.25, 0.3},
                                         {-2.7, 1.8, -3.0, 1.8, 0.3},
                                         {-2.7, 1.575, -3.0, 1.35, 0.3},
                                         {-2.5, 1.125, -2.65, 0.9375, 0.3},
                                         {-2.0, 0.9, -1.9, 0.6, 0.3}}};
constexpr std::array<Rung, 7> spout = {{{1.7, 1.425, 1.7, 0.6, 0.66},
                                        {2.6, 1.425, 3.1, 0.825, 0.66},
                                        {2.3, 2.1, 2.4, 2.025, 0.25},
                                        {2.7, 2.4, 3.3, 2.4, 0.25},
                                        {2.8, 2.475, 3.525, 2.49375, 0.25},
                                        {2.9, 2.475, 3.45, 2.5125, 0.15},
                                        {2.8, 2.4, 3.2, 2.4, 0.15}}};

// One of the four quarters, each turned clockwise (seen from above) from the one before.
BezierPatch quarter(const std::array<Ring, 4>& rings, int number)
{
    BezierPatch patch;
    for (std::size_t row = 0; row < 4; ++row) {
        const auto [radius, height, bulge] = rings[row];
        patch[row] = {{{radius, 0.0, height},
                       {radius, -bulge, height},
                       {bulge, -radius, height},
                       {0.0, -radius, height}}};
        for (glm::dvec3& point : patch[row])
            for (int turn = 0; turn < number; ++turn)
                point = {point.y, -point.x, point.z};
    }
    return patch;
}

BezierPatch half_tube(std::span<const Rung, 4> rungs, bool far_side)
{
    BezierPatch patch;
    for (std::size_t row = 0; row < 4; ++row) {
        const auto [x1, z1, x2, z2, width] = rungs[row];
        if (far_side)
            patch[row] = {{{x2, 0.0, z2}, {x2, width, z2}, {x1, width, z1}, {x1, 0.0, z1}}};
        else
            patch[row] = {{{x1, 0.0, z1}, {x1, -width, z1}, {x2, -width, z2}, {x2, 0.0, z2}}};
    }
    return patch;
}

struct Basis {
    std::array<double, 4> value;
    std::array<double, 4> slope;
};

// Cubic Bernstein polynomials and their derivatives.
Basis bernstein(double t)
{
    const double s = 1.0 - t;
    return {{s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t},
            {-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t}};
}

glm::dvec3 combine(const BezierPatch& patch, const std::array<double, 4>& rows,
                   const std::array<double, 4>& columns)
{
    glm::dvec3 sum(0.0);
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            sum += patch[row][column] * (rows[row] * columns[column]);
    return sum;
}

struct SurfacePoint {
    glm::dvec3 position;
    glm::dvec3 normal;
};

SurfacePoint evaluate(const BezierPatch& patch, double u, double v)
{
    const Basis across = bernstein(u);
    const Basis down = bernstein(v);
    const glm::dvec3 along_v = combine(patch, down.slope, across.value);
    glm::dvec3 along_u = combine(patch, down.value, across.slope);
    // Where a row collapses to a point, the mixed derivative gives the direction of the vanishing derivative.
    if (glm::length(along_u) < 1e-9)
        along_u = combine(patch, down.slope, across.slope) * (v < 0.5 ? 1.0 : -1.0);
    return {combine(patch, down.value, across.value), glm::normalize(glm::cross(along_u, along_v))};
}

bool is_point(const std::array<glm::dvec3, 4>& row)
{
    return row[0] == row[1] && row[1] == row[2] && row[2] == row[3];
}

glm::vec3 y_up(glm::dvec3 v)
{
    return {v.x, v.z, -v.y};
}

void add_vertices(const BezierPatch& patch, int subdivisions, Mesh& mesh)
{
    for (int row = 0; row <= subdivisions; ++row) {
        for (int column = 0; column <= subdivisions; ++column) {
            const double u = static_cast<double>(column) / subdivisions;
            const double v = static_cast<double>(row) / subdivisions;
            const SurfacePoint point = evaluate(patch, u, v);
            mesh.positions.push_back(y_up(point.position * teapot_scale));
            mesh.normals.push_back(y_up(point.normal));
            mesh.texcoords[0].push_back(glm::vec2(u, v));
        }
    }
}

void add_triangles(const BezierPatch& patch, int subdivisions, std::uint32_t first, Mesh& mesh)
{
    const auto vertex = [&](int row, int column) {
        return first + static_cast<std::uint32_t>(row * (subdivisions + 1) + column);
    };
    for (int row = 0; row < subdivisions; ++row) {
        for (int column = 0; column < subdivisions; ++column) {
            const std::uint32_t here = vertex(row, column);
            const std::uint32_t across = vertex(row, column + 1);
            const std::uint32_t below = vertex(row + 1, column);
            const std::uint32_t opposite = vertex(row + 1, column + 1);
            if (row != 0 || !is_point(patch[0]))
                mesh.triangles.push_back({here, across, opposite});
            if (row + 1 != subdivisions || !is_point(patch[3]))
                mesh.triangles.push_back({here, opposite, below});
        }
    }
}

} // namespace

std::array<BezierPatch, 32> teapot_patches()
{
    std::array<BezierPatch, 32> patches;
    auto next = patches.begin();
    const auto add_quarters = [&](const std::array<Ring, 4>& rings) {
        for (int number = 0; number < 4; ++number)
            *next++ = quarter(rings, number);
    };
    const auto add_tube = [&](const std::array<Rung, 7>& rungs) {
        for (const std::span<const Rung, 4> part :
             {std::span<const Rung, 4>(rungs.data(), 4), std::span<const Rung, 4>(rungs.data() + 3, 4)}) {
            *next++ = half_tube(part, false);
            *next++ = half_tube(part, true);
        }
    };
    add_quarters(rim);
    add_quarters(upper_body);
    add_quarters(lower_body);
    add_tube(handle);
    add_tube(spout);
    add_quarters(knob);
    add_quarters(lid);
    add_quarters(bottom);
    return patches;
}

Mesh make_teapot(int subdivisions)
{
    Mesh mesh;
    for (const BezierPatch& patch : teapot_patches()) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        add_vertices(patch, subdivisions, mesh);
        add_triangles(patch, subdivisions, first, mesh);
    }
    return mesh;
}

} // namespace lambent::scene
