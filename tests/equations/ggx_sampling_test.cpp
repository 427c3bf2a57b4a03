// Chi-square of the sampler of visible normals against its density.
#include "tests/equations/directions.h"
#include "tests/equations/reference_ggx.h"
#include "tests/support/chi_square.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>

namespace lambent::test {
namespace {

using in_double::sample_visible_ggx;
using in_double::stretched_view;

struct Sampling {
    double NV;
    double alpha;
};

constexpr int draws = 200000, rows = 24, columns = 36;

vec3 view(double NV)
{
    return {std::sqrt((1.0 - NV) * (1.0 + NV)), 0.0, NV};
}

vec3 draw_normal(const Sampling& s, Uniform& uniform)
{
    const double xi1 = uniform(), xi2 = uniform();
    const vec3 point(xi2, std::cos(2.0 * pi * xi1), std::sin(2.0 * pi * xi1));
    return sample_visible_ggx(stretched_view(view(s.NV), vec2(s.alpha)), vec2(s.alpha), point).normal;
}

size_t cell_of(double row, double azimuth)
{
    return part_of(row, rows) * columns + part_of_turn(azimuth, columns);
}

// Directions mirrored by the facets, in cells of equal solid angle over the whole sphere.
std::vector<double> count_mirrored(const Sampling& s, uint64_t seed)
{
    Uniform uniform(seed);
    const vec3 V = view(s.NV);
    return count(draws, rows * columns, [&] {
        const vec3 h = draw_normal(s, uniform);
        const double twice = 2.0 * cosine_between(h, V);
        const vec3 L(twice * h.x - V.x, twice * h.y - V.y, twice * h.z - V.z);
        return cell_of(0.5 * (1.0 + L.z), std::atan2(L.y, L.x));
    });
}

// D G1 / (4 NV) at the facet halfway between L and V.
double mirrored_density(const Sampling& s, vec3 L)
{
    const vec3 V = view(s.NV);
    const vec3 sum(L.x + V.x, L.y + V.y, L.z + V.z);
    const double NH = sum.z / std::hypot(sum.x, sum.y, sum.z);
    return NH > 0.0 ? facet_density(NH, s.alpha) / (1.0 + smith_lambda(s.NV, s.alpha)) / (4.0 * s.NV) : 0.0;
}

// Integral of a density of z and azimuth over each cell, z from `low` of its row (where it may begin later).
template <class F>
std::vector<double> integrate_cells(const F& density, double z_begin, double z_from)
{
    using Rule = boost::math::quadrature::gauss<double, 15>;
    std::vector<double> cells(rows * columns);
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++) {
            const double z0 = z_begin + (1.0 - z_begin) * i / rows,
                         z1 = z_begin + (1.0 - z_begin) * (i + 1) / rows;
            const double from = std::max(z0, z_from);
            const auto ring = [&](double z) {
                const auto point = [&](double phi) { return density(z, phi); };
                return Rule::integrate(point, 2.0 * pi * j / columns, 2.0 * pi * (j + 1) / columns);
            };
            cells[static_cast<size_t>(i * columns + j)] = z1 > from ? Rule::integrate(ring, from, z1) : 0.0;
        }
    return cells;
}

std::vector<double> expect_mirrored(const Sampling& s)
{
    // Nothing is mirrored below z = -NV: the facet would look down.
    const auto density = [&](double z, double phi) {
        const double r = std::sqrt((1.0 - z) * (1.0 + z));
        return mirrored_density(s, vec3(r * std::cos(phi), r * std::sin(phi), z));
    };
    return integrate_cells(density, -1.0, -s.NV);
}

TEST(GgxSampling, MirroredDirectionsFollowTheirDensity)
{
    uint64_t seed = 1;
    for (const Sampling s : {Sampling{0.1, 0.3}, Sampling{0.5, 0.3}, Sampling{0.98, 0.3}, Sampling{0.2, 0.6},
                             Sampling{0.7, 0.6}, Sampling{0.3, 1.0}, Sampling{1.0, 1.0}})
        EXPECT_TRUE(follows(count_mirrored(s, seed++), expect_mirrored(s)))
            << "NV " << s.NV << ", alpha " << s.alpha;
}

// Smooth surfaces, whose facets a grid over the sphere would not resolve: the radial coordinate is s = r^2 /
// (1 + r^2) with r = slope / alpha, in which D NH is uniform.
std::vector<double> count_normals(const Sampling& s, uint64_t seed)
{
    Uniform uniform(seed);
    return count(draws, rows * columns, [&] {
        const vec3 h = draw_normal(s, uniform);
        const double r2 = (h.x * h.x + h.y * h.y) / (h.z * h.z * s.alpha * s.alpha);
        return cell_of(r2 / (1.0 + r2), std::atan2(h.y, h.x));
    });
}

// Visible normals have the density D G1 max(VH, 0) / NV per solid angle: that of D NH times G1 (VH / NH) /
// NV.
std::vector<double> expect_normals(const Sampling& s)
{
    const double SV = std::sqrt((1.0 - s.NV) * (1.0 + s.NV)), G1 = 1.0 / (1.0 + smith_lambda(s.NV, s.alpha));
    const auto density = [&](double t, double phi) {
        const double slope = s.alpha * std::sqrt(t / (1.0 - t));
        return G1 * std::max(s.NV + SV * slope * std::cos(phi), 0.0) / s.NV / (2.0 * pi);
    };
    return integrate_cells(density, 0.0, 0.0);
}

TEST(GgxSampling, NormalsOfSmoothSurfacesFollowTheirDensity)
{
    uint64_t seed = 11;
    for (const Sampling s : {Sampling{0.02, 1e-4}, Sampling{0.5, 1e-4}, Sampling{1.0, 1e-3},
                             Sampling{0.3, 1e-2}, Sampling{0.5, 0.1}})
        EXPECT_TRUE(follows(count_normals(s, seed++), expect_normals(s)))
            << "NV " << s.NV << ", alpha " << s.alpha;
}

// Would the test notice? The density of another alpha, and that of all normals instead of the visible ones.
TEST(GgxSampling, WrongDensitiesAreRefused)
{
    const Sampling s = {0.5, 0.3};
    EXPECT_FALSE(follows(count_mirrored(s, 21), expect_mirrored({0.5, 0.306})));
    EXPECT_FALSE(follows_evenly(count_normals(s, 22)));
}

} // namespace
} // namespace lambent::test
