#include "tests/equations/directions.h"
#include "tests/equations/reference_ggx.h"

#include <gtest/gtest.h>

namespace lambent::test {
namespace {

using in_double::density_ggx;
using in_double::masking_ggx;
using in_double::sample_visible_ggx;
using in_double::shadowing_ggx;
using in_double::slope_ggx;
using in_double::smith_ggx;
using in_double::spread_ggx;
using in_double::stretched_view;
using in_double::visibility_ggx;
using in_double::VisibleFacet;

TEST(Ggx, FacetsCoverTheSurfaceOnce)
{
    for (double alpha : {1e-4, 1e-3, 0.01, 0.1, 0.5, 1.0})
        EXPECT_NEAR(integrate_about_pole([&](double c) { return density_ggx(c, alpha) * c; }), 1.0, 1e-6)
            << alpha;
}

TEST(Ggx, DensityFromSlopes)
{
    for (double alpha : {1e-4, 0.03, 0.4, 1.0})
        for (double c : {0.01, 0.5, 0.9, 0.999999, 1.0})
            EXPECT_NEAR(density_ggx(c, alpha) / facet_density(c, alpha), 1.0, 1e-7) << alpha << " " << c;
}

// The weak white furnace: facets that face the view, times the fraction of them seen, cover what the surface
// itself covers. [Heitz 2014, eq. 14]
TEST(Ggx, VisibleFacetsCoverTheViewOfTheSurface)
{
    for (double alpha : {0.02, 0.1, 0.4, 1.0})
        for (double NV : {0.03, 0.2, 0.6, 1.0})
            EXPECT_NEAR(masking_ggx(NV, alpha) * facing_projected_area(NV, alpha), NV, 2e-6)
                << alpha << " " << NV;
}

TEST(Ggx, SmithTermIsTheCosineTimesOnePlusTwoLambda)
{
    for (double alpha : {1e-4, 0.02, 0.4, 1.0})
        for (double c : {0.001, 0.2, 0.6, 1.0})
            EXPECT_NEAR(smith_ggx(c, alpha), c * (1.0 + 2.0 * smith_lambda(c, alpha)), 1e-13);
    EXPECT_DOUBLE_EQ(smith_ggx(0.0, 0.3), 0.3);
}

// G2 = 1 / (1 + Lambda(V) + Lambda(L)) with each Lambda from the weak furnace by quadrature.
TEST(Ggx, VisibilityIsHeightCorrelated)
{
    for (double alpha : {0.05, 0.3, 1.0})
        for (double NV : {0.05, 0.5, 1.0})
            for (double NL : {0.1, 0.9}) {
                const double of_view = facing_projected_area(NV, alpha) / NV - 1.0;
                const double of_light = facing_projected_area(NL, alpha) / NL - 1.0;
                const double G2 = 1.0 / (1.0 + of_view + of_light);
                EXPECT_NEAR(visibility_ggx(NL, NV, alpha) * 4.0 * NL * NV / G2, 1.0, 1e-4);
            }
}

TEST(Ggx, ShadowingIsWhatRemainsAfterMasking)
{
    for (double alpha : {1e-4, 0.05, 0.3, 1.0})
        for (double NV : {0.01, 0.3, 1.0})
            for (double NL : {0.01, 0.5, 1.0}) {
                const double G2 = 1.0 / (1.0 + smith_lambda(NV, alpha) + smith_lambda(NL, alpha));
                const double G1 = 1.0 / (1.0 + smith_lambda(NV, alpha));
                EXPECT_NEAR(shadowing_ggx(NL, NV, alpha), G2 / G1, 1e-13);
                EXPECT_NEAR(shadowing_ggx(NL, NV, alpha) * masking_ggx(NV, alpha),
                            visibility_ggx(NL, NV, alpha) * 4.0 * NL * NV, 1e-13);
                EXPECT_LE(shadowing_ggx(NL, NV, alpha), 1.0);
            }
}

TEST(Ggx, VisibilityIsReciprocal)
{
    for (double alpha : {0.01, 0.5})
        EXPECT_EQ(visibility_ggx(0.2, 0.7, alpha), visibility_ggx(0.7, 0.2, alpha));
}

TEST(Ggx, StretchedViewIsAUnitVectorTowardsTheView)
{
    // In the stretched space the view (sin, 0, cos) has its x multiplied by alpha.
    for (double alpha : {0.01, 0.5, 1.0})
        for (double theta : {0.0, 0.4, 1.5}) {
            const vec3 v = stretched_view({std::sin(theta), 0.0, std::cos(theta)}, vec2(alpha));
            EXPECT_NEAR(std::hypot(v.x, v.y, v.z), 1.0, 1e-14);
            EXPECT_EQ(v.y, 0.0);
            EXPECT_NEAR(v.x * std::cos(theta), alpha * std::sin(theta) * v.z, 1e-15);
        }
}

// Every sample, corners included, has a unit normal that faces the view, and a finite spread of
// 1 / (D G1 / (4 NV)).
TEST(Ggx, SpreadIsTheReciprocalOfTheDensity)
{
    Uniform uniform(1);
    for (double alpha : {1e-4, 1e-2, 0.3, 1.0})
        for (double NV : {1e-3, 0.1, 0.7, 1.0})
            for (int i = 0; i < 500; i++) {
                const double xi1 = uniform(), xi2 = i == 0 ? 0.0 : i == 1 ? 1.0 - 1e-7 : uniform();
                const vec3 point(xi2, std::cos(2.0 * pi * xi1), std::sin(2.0 * pi * xi1));
                const VisibleFacet facet = sample_visible_ggx(
                    stretched_view({std::sqrt((1.0 - NV) * (1.0 + NV)), 0.0, NV}, vec2(alpha)), vec2(alpha),
                    point);
                const vec3 h = facet.normal, V(std::sqrt((1.0 - NV) * (1.0 + NV)), 0.0, NV);
                ASSERT_NEAR(std::hypot(h.x, h.y, h.z), 1.0, 1e-13);
                ASSERT_GE(cosine_between(h, V), -1e-9);
                const double sine2 = h.x * h.x + h.y * h.y; // 1 - h.z^2 without its cancellation
                const double D = alpha * alpha / (pi * std::pow(alpha * alpha * h.z * h.z + sine2, 2.0));
                const double density = D / (1.0 + smith_lambda(NV, alpha)) / (4.0 * NV);
                ASSERT_NEAR(facet.spread * spread_ggx(NV, smith_ggx(NV, alpha), vec2(alpha)) * density, 1.0,
                            1e-9)
                    << alpha << " " << NV;
            }
}

vec3 along(double cosine, double azimuth)
{
    const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

// By slopes p and q along either axis, as facet_density with each over its own alpha.
TEST(Ggx, TwoAlphasStretchTheSlopes)
{
    for (const vec2 alpha : {vec2(0.6, 0.1), vec2(0.2, 0.9)})
        for (double c : {0.2, 0.7, 1.0})
            for (double azimuth : {0.0, 0.7, 1.5, 4.0}) {
                const vec3 h = along(c, azimuth);
                const double p = h.x / (c * alpha.x), q = h.y / (c * alpha.y), r = 1.0 + p * p + q * q;
                const double D = 1.0 / (pi * alpha.x * alpha.y * r * r * c * c * c * c);
                EXPECT_NEAR(density_ggx(h, alpha), D, 1e-12 * D);
                EXPECT_NEAR(slope_ggx(h, alpha), alpha.x * alpha.y * c * c * r, 1e-12);
                const double own = std::hypot(alpha.x * std::cos(azimuth), alpha.y * std::sin(azimuth));
                EXPECT_NEAR(smith_ggx(h, alpha), smith_ggx(c, own), 1e-13);
                const vec3 V = along(0.4, 2.0);
                const double seen = std::hypot(alpha.x * std::cos(2.0), alpha.y * std::sin(2.0));
                const double G2 = 1.0 / (1.0 + smith_lambda(c, own) + smith_lambda(0.4, seen));
                EXPECT_NEAR(visibility_ggx(h, V, alpha) * 4.0 * c * 0.4, G2, 1e-12);
            }
}

TEST(Ggx, TwoEqualAlphasAreOne)
{
    for (double alpha : {0.01, 0.3, 1.0})
        for (double c : {0.1, 0.8, 1.0}) {
            const vec3 w = along(c, 1.0);
            EXPECT_NEAR(density_ggx(w, vec2(alpha)) / density_ggx(c, alpha), 1.0, 1e-9);
            EXPECT_NEAR(smith_ggx(w, vec2(alpha)), smith_ggx(c, alpha), 1e-13);
            EXPECT_NEAR(visibility_ggx(w, w, vec2(alpha)) / visibility_ggx(c, c, alpha), 1.0, 1e-12);
        }
}

// The integral of D NH over the hemisphere is 1, and a sample's spread the reciprocal of its density, with two alphas too.
TEST(Ggx, TwoAlphasKeepTheArea)
{
    Uniform uniform(2);
    for (const vec2 alpha : {vec2(0.6, 0.1), vec2(0.2, 0.9)}) {
        const auto ring = [&](double t) { // 1 - cosine = t^4, finer towards the pole
            const double c = 1.0 - t * t * t * t;
            const auto at = [&](double azimuth) { return density_ggx(along(c, azimuth), alpha) * c; };
            return integrate(at, 0.0, 2.0 * pi, 1e-9, 4) * 4.0 * t * t * t;
        };
        EXPECT_NEAR(integrate(ring, 0.0, 1.0, 1e-8, 8), 1.0, 1e-6);
        for (int i = 0; i < 500; i++) {
            const double xi2 = uniform(), turn = 2.0 * pi * uniform();
            const vec3 V = along(0.05 + 0.95 * uniform(), 2.0 * pi * uniform());
            const VisibleFacet facet = sample_visible_ggx(stretched_view(V, alpha), alpha,
                                                          vec3(xi2, std::cos(turn), std::sin(turn)));
            ASSERT_GE(cosine_between(facet.normal, V), -1e-9);
            const double SV = smith_ggx(V, alpha), G1 = 2.0 * V.z / (V.z + SV);
            const double density = density_ggx(facet.normal, alpha) * G1 / (4.0 * V.z);
            ASSERT_NEAR(facet.spread * spread_ggx(V.z, SV, alpha) * density, 1.0, 1e-8);
        }
    }
}

} // namespace
} // namespace lambent::test
