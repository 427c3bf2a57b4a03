// What is seen of lamps through a GGX lobe and a pixel, in double, against the lobe's definition.
#include "tests/equations/directions.h"
#include "tests/equations/reference_ggx.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lambent::in_double {
namespace {

#include "tests/equations/lobe_hooks.h"

vec3 view_at(double NV)
{
    return {std::sqrt((1.0 - NV) * (1.0 + NV)), 0.0, NV};
}

// What is not drawn is mirrored to below the horizon; of the roughest surface seen head on that is half.
TEST(SpecularGgx, FacetsLeftOutMirrorNothing)
{
    EXPECT_NEAR(reflecting_share_ggx(view_at(1.0), vec2(1.0)), 0.5, 1e-12);
    EXPECT_NEAR(reflecting_share_ggx(view_at(0.5), vec2(1e-6)), 1.0, 1e-9);
    for (double alpha : {0.05, 0.3, 0.7, 1.0})
        for (double NV : {0.05, 0.4, 0.8, 1.0}) {
            const vec3 V = view_at(NV), stretched = stretched_view(V, vec2(alpha));
            const double share = reflecting_share_ggx(V, vec2(alpha));
            for (int i = 0; i < 2000; ++i) {
                const double turn = 2.4 * i, xi2 = share + (1.0 - share) * (i + 0.5) / 2000;
                const vec3 h =
                    sample_visible_ggx(stretched, vec2(alpha), vec3(xi2, std::cos(turn), std::sin(turn)))
                        .normal;
                ASSERT_LT(2.0 * dot(V, h) * h.z - V.z, 1e-9) << alpha << " " << NV << " " << xi2;
            }
        }
}

vec3 at_angles(double theta, double phi)
{
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

// A lamp that no blur holds is seen by the lobe itself: D G2 / (4 NV), with and without Schlick's weight.
TEST(SpecularGgx, LampsAreSeenThroughTheLobe)
{
    for (double alpha : {0.02, 0.1, 0.4, 1.0})
        for (double NV : {0.1, 0.5, 1.0})
            for (double theta : {0.0, 0.4, 1.0, 1.5})
                for (double phi : {0.0, 1.0, 3.1}) {
                    const vec3 V = view_at(NV), L = at_angles(theta, phi), H = normalize(L + V);
                    const Mirror mirror = {{{0.0, 0.0, 1.0}, V, vec3(0.0), vec3(0.0)},
                                           {0.0, 1.0, 0.0},
                                           vec2(alpha),
                                           vec3(0.0),
                                           {0.7, 0.2}};
                    const LobeLight light = specular_ggx({L, {1.0e-12, 2.0e-12}}, mirror);
                    const double lobe =
                        test::facet_density(H.z, alpha) /
                        (1.0 + test::smith_lambda(NV, alpha) + test::smith_lambda(L.z, alpha)) / (4.0 * NV);
                    const double grazing = std::pow(1.0 - dot(V, H), 5.0);
                    const double plain = lobe * (1.0 - grazing) / 0.7;
                    EXPECT_NEAR(light.plain.x, plain, 1e-6 * plain + 1e-12)
                        << alpha << " " << NV << " " << theta;
                    EXPECT_NEAR(light.plain.z, 3.0 * light.plain.x, 1e-12 + 1e-12 * plain);
                    EXPECT_NEAR(light.grazing.x, lobe * grazing / 0.2, 1e-6 * lobe + 1e-12);
                }
}

// The same of facets that are stretched: D and Lambda by slopes along either axis.
TEST(SpecularGgx, LampsAreSeenThroughAStretchedLobe)
{
    stretch = 1;
    for (const vec2 alpha : {vec2(0.5, 0.1), vec2(0.1, 0.4)})
        for (double NV : {0.3, 1.0})
            for (double theta : {0.2, 1.0})
                for (double phi : {0.5, 3.1}) {
                    const vec3 V = view_at(NV), L = at_angles(theta, phi), H = normalize(L + V);
                    const vec3 N(0.0, 0.0, 1.0), T(0.6, 0.8, 0.0), B(-0.8, 0.6, 0.0);
                    const Mirror mirror = {
                        {N, V, vec3(0.0), vec3(0.0)}, {0.0, 1.0, 0.0}, alpha, T, {0.7, 0.2}};
                    const LobeLight light = specular_ggx({L, {1.0e-12, 2.0e-12}}, mirror);
                    const double p = dot(T, H) / (H.z * alpha.x), q = dot(B, H) / (H.z * alpha.y);
                    const double D = 1.0 / (std::numbers::pi * alpha.x * alpha.y *
                                            std::pow(1.0 + p * p + q * q, 2.0) * std::pow(H.z, 4.0));
                    const auto lambda = [&](vec3 w) {
                        const double azimuth = std::atan2(dot(B, w), dot(T, w));
                        return test::smith_lambda(
                            w.z, std::hypot(alpha.x * std::cos(azimuth), alpha.y * std::sin(azimuth)));
                    };
                    const double lobe = D / (1.0 + lambda(V) + lambda(L)) / (4.0 * NV);
                    const double grazing = std::pow(1.0 - dot(V, H), 5.0),
                                 plain = lobe * (1.0 - grazing) / 0.7;
                    EXPECT_NEAR(light.plain.x, plain, 1e-6 * plain + 1e-12) << theta << ' ' << phi;
                }
    stretch = 0;
}

// A lamp that all blurs hold is not added again.
TEST(SpecularGgx, LampsInTheBlursAreLeftToThem)
{
    const Mirror mirror = {{{0.0, 0.0, 1.0}, view_at(0.7), vec3(0.0), vec3(0.0)},
                           {0.0, 1.0, 0.0},
                           vec2(0.3),
                           vec3(0.0),
                           {0.7, 0.2}};
    const LobeLight light = specular_ggx({{0.0, 0.6, 0.8}, {1.0e3, 4.0e3}}, mirror);
    EXPECT_EQ(light.plain.x, 0.0);
    EXPECT_EQ(light.grazing.x, 0.0);
}

// A pixel's places, put through a mirror, are spread evenly over a parallelogram: its area, middle and variance.
TEST(SpecularGgx, APixelSeesAMirrorAsWideAsItIs)
{
    const vec3 N(0.0, 0.0, 1.0), V = view_at(0.8);
    const vec3 R(-V.x, 0.0, V.z), aside(0.0, 1.0, 0.0), up = cross(R, aside);
    const vec3 dx = 0.03 * aside + 0.01 * up, dy = 0.002 * aside - 0.02 * up;
    const Footprint footprint = footprint_of({N, V, dx, dy});
    const double area = 0.03 * 0.02 + 0.002 * 0.01; // of the parallelogram
    EXPECT_NEAR(footprint.size, area, 1e-9);
    double sum = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
    constexpr double step = 0.01;
    for (double a = -3.0; a < 3.0; a += step)
        for (double b = -3.0; b < 3.0; b += step) {
            const vec3 L = normalize(R + (a + 0.5 * step) * dx + (b + 0.5 * step) * dy);
            const double share = density_in_pixel(footprint, L) * area * step * step;
            sum += share, xx += share * a * a, yy += share * b * b, xy += share * a * b;
        }
    EXPECT_NEAR(sum, 1.0, 0.01);
    EXPECT_NEAR(xx, 1.0 / 12.0, 0.002);
    EXPECT_NEAR(yy, 1.0 / 12.0, 0.002);
    EXPECT_NEAR(xy, 0.0, 0.002);
    EXPECT_EQ(density_in_pixel(footprint, -R), 0.0);
}

// What a pixel `width` wide sees of a sky of lamps, through the plain part alone.
double seen_of_a_white_sky(double alpha, double width, double albedo)
{
    const vec3 V = view_at(0.9), R(-V.x, 0.0, V.z), aside(0.0, 1.0, 0.0), up = cross(R, aside);
    const Mirror mirror = {
        {{0.0, 0.0, 1.0}, V, width * aside, width * up}, aside, vec2(alpha), vec3(0.0), {albedo, 0.0}};
    constexpr int rings = 400, steps = 48;
    double seen = 0.0;
    for (int i = 0; i < rings; ++i) { // about R, finer towards it
        const double t = (i + 0.5) / rings, theta = 1.5 * t * t * t * t, wide = 6.0 * t * t * t / rings;
        for (int j = 0; j < steps; ++j) {
            const double phi = 2.0 * std::numbers::pi * (j + 0.5) / steps;
            const vec3 L =
                std::cos(theta) * R + std::sin(theta) * (std::cos(phi) * aside + std::sin(phi) * up);
            seen += std::sin(theta) * wide * 2.0 * std::numbers::pi / steps *
                    specular_ggx({L, {1.0e-14, 2.0e-14}}, mirror).plain.x;
        }
    }
    return seen;
}

// Lobe, pixel or both, the sky gives back its own radiance. Where a lobe is about as wide as the pixel the one is faded
// into the other, and the sum is not exact.
TEST(SpecularGgx, LampsAllAroundAreAWhiteSky)
{
    for (double width : {0.02, 0.06, 0.2})
        for (double alpha : {1.0e-4, 0.003, 0.01, 0.03, 0.1}) {
            const double albedo = seen_of_a_white_sky(alpha, 0.0, 1.0);
            const double seen = seen_of_a_white_sky(alpha, width, albedo);
            EXPECT_NEAR(seen, 1.0, 0.06) << "alpha " << alpha << ", pixel " << width;
        }
}

} // namespace
} // namespace lambent::in_double