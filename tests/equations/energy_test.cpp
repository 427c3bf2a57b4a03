#include "tests/equations/directions.h"
#include "tests/equations/reference_ggx.h"

#include <gtest/gtest.h>

namespace lambent::test {
namespace {

using in_double::brdf_metallic;
using in_double::energy_compensation;
using in_double::Metallic;
using in_double::Reflectance;
using in_double::reflectance_metallic;

vec3 view(double NV)
{
    return {std::sqrt((1.0 - NV) * (1.0 + NV)), 0.0, NV};
}

// Integral over the upper hemisphere of f(L) NL for a view in the half plane y = 0, x > 0; f is even in y.
// The panels are halved towards the mirror direction, where f may have a narrow peak.
template <class F>
double integrate_over_light(const F& f, double NV, double tolerance = 1e-7)
{
    const double mirror = std::acos(NV);
    const auto ring = [&](double theta) {
        const auto at = [&](double phi) { return f(from_angles(theta, phi)); };
        const double around = integrate_between(at, {0.0, 0.5 * pi, pi - 0.3, pi - 0.03, pi}, tolerance);
        return 2.0 * around * std::cos(theta) * std::sin(theta);
    };
    std::vector<double> breaks = {0.0};
    for (double theta : {mirror - 0.3, mirror - 0.03, mirror, mirror + 0.03, mirror + 0.3})
        if (theta > breaks.back() && theta < 0.5 * pi)
            breaks.push_back(theta);
    breaks.push_back(0.5 * pi);
    return integrate_between(ring, breaks, tolerance);
}

struct Setting {
    double NV;
    double alpha;
};

// Fraction of uniform light that the facets send to the view after one reflection, for Schlick's reflectance
// of F0 and F90; from formulas that are not the text's.
double albedo_by_quadrature(const Setting& s, double F0, double F90)
{
    const vec3 V = view(s.NV);
    const auto lobe = [&](vec3 L) {
        const double x = L.x + V.x, y = L.y + V.y, z = L.z + V.z, length = std::hypot(x, y, z);
        const double G2 = 1.0 / (1.0 + smith_lambda(s.NV, s.alpha) + smith_lambda(L.z, s.alpha));
        const double F = F0 + (F90 - F0) * std::pow(1.0 - 0.5 * length, 5.0); // VH = |L + V| / 2
        return facet_density(z / length, s.alpha) * G2 / (4.0 * L.z * s.NV) * F;
    };
    return integrate_over_light(lobe, s.NV);
}

// The split-sum pair: what F0 scales, and what is there without it.
vec2 split_sum(const Setting& s)
{
    return {albedo_by_quadrature(s, 1.0, 0.0), albedo_by_quadrature(s, 0.0, 1.0)};
}

constexpr Setting settings[] = {{0.1, 0.05}, {0.8, 0.05}, {0.1, 0.3}, {0.5, 0.3},
                                {0.05, 1.0}, {0.4, 1.0},  {1.0, 1.0}};

vec3 reflected(const Metallic& m, vec2 albedo, double NV)
{
    const auto channel = [&](double vec3::*c) {
        const auto f = [&](vec3 L) { return brdf_metallic(m, albedo, vec3(0, 0, 1), view(NV), L).*c; };
        return integrate_over_light(f, NV);
    };
    return {channel(&vec3::x), channel(&vec3::y), channel(&vec3::z)};
}

TEST(Energy, WhiteFurnaceIsOneForEveryMixture)
{
    for (const Setting& s : settings) {
        const vec2 albedo = split_sum(s);
        EXPECT_LT(albedo.x + albedo.y, 1.0);
        for (double metalness : {0.0, 0.5, 1.0}) {
            const Metallic white = {vec3(1.0), metalness, vec2(s.alpha), vec3(0.0), 1.0};
            const auto f = [&](vec3 L) {
                return brdf_metallic(white, albedo, vec3(0, 0, 1), view(s.NV), L).x;
            };
            EXPECT_NEAR(integrate_over_light(f, s.NV), 1.0, 2e-5)
                << "NV " << s.NV << ", alpha " << s.alpha << ", metalness " << metalness;
        }
    }
}

TEST(Energy, ReflectanceIsTheIntegralOfTheBrdf)
{
    for (const Setting& s : {Setting{0.2, 0.15}, Setting{0.7, 0.5}, Setting{0.4, 1.0}}) {
        const vec2 albedo = split_sum(s);
        for (double metalness : {0.0, 0.3, 1.0}) {
            const Metallic m = {vec3(0.9, 0.3, 0.0), metalness, vec2(s.alpha), vec3(0.0), 1.0};
            const Reflectance r = reflectance_metallic(m, albedo);
            const vec3 total = r.plain + r.grazing + r.diffuse;
            EXPECT_LT(distance(total, reflected(m, albedo, s.NV)), 3e-5)
                << "NV " << s.NV << ", alpha " << s.alpha << ", metalness " << metalness;
        }
    }
}

TEST(Energy, SingleScatteringIsTheUncompensatedLobe)
{
    const Setting s = {0.3, 0.6};
    const vec2 albedo = split_sum(s);
    const double metal = albedo_by_quadrature(s, 0.9, 1.0), dielectric = albedo_by_quadrature(s, 0.04, 1.0);
    for (double metalness : {0.0, 0.4, 1.0}) {
        const Reflectance r =
            reflectance_metallic({vec3(0.9), metalness, vec2(s.alpha), vec3(0.0), 0.0}, albedo);
        const double lobe = metalness * metal + (1.0 - metalness) * dielectric;
        EXPECT_NEAR(r.plain.x + r.grazing.x, lobe, 1e-5) << metalness;
        EXPECT_NEAR(r.diffuse.x, (1.0 - metalness) * 0.9 * (1.0 - dielectric), 1e-5) << metalness;
    }
}

// The diffuse layer and the parts of the lobe, each by itself: a dielectric of black base has no diffuse part
// and reflects F0 A + B of the light, compensated; a metal has none either.
TEST(Energy, PartsOfTheReflectance)
{
    const vec2 albedo(0.6, 0.1);
    const Reflectance black = reflectance_metallic({vec3(0.0), 0.0, vec2(0.5), vec3(0.0), 1.0}, albedo);
    EXPECT_EQ(black.diffuse.x, 0.0);
    const double gain = 1.0 + 0.04 * (1.0 - 0.7) / 0.7;
    EXPECT_NEAR(black.plain.x, 0.04 * 0.6 * gain, 1e-15);
    EXPECT_NEAR(black.grazing.x, 0.1 * gain, 1e-15);
    const Reflectance metal =
        reflectance_metallic({vec3(0.9, 0.5, 0.2), 1.0, vec2(0.5), vec3(0.0), 1.0}, albedo);
    EXPECT_EQ(distance(metal.diffuse, vec3(0.0)), 0.0);
    EXPECT_NEAR(metal.plain.y, 0.5 * 0.6 * (1.0 + 0.5 * 0.3 / 0.7), 1e-15);
    EXPECT_NEAR(metal.grazing.z, 0.1 * (1.0 + 0.2 * 0.3 / 0.7), 1e-15);
}

TEST(Energy, CompensationGivesAWhiteMetalItsLossBack)
{
    for (double E : {0.3, 0.7, 1.0}) {
        const vec3 gain = energy_compensation(vec3(0.0, 0.5, 1.0), vec2(E - 0.05, 0.05), 1.0);
        EXPECT_DOUBLE_EQ(gain.x, 1.0);
        EXPECT_NEAR(gain.y, 0.5 + 0.5 / E, 1e-14);
        EXPECT_NEAR(gain.z * E, 1.0, 1e-14);
        EXPECT_EQ(energy_compensation(vec3(1.0), vec2(E - 0.05, 0.05), 0.0).x, 1.0);
    }
}

TEST(Energy, FiniteWhereTheTableIsEmpty)
{
    EXPECT_LT(energy_compensation(vec3(1.0), vec2(0.0, 0.0), 1.0).x, 1.1e4);
}

TEST(Energy, LobeIsReciprocal)
{
    // Without the diffuse term, whose albedo scaling knows the view alone: a metal.
    Uniform uniform(1);
    for (int i = 0; i < 200; i++) {
        const vec3 a = from_angles(uniform.between(0.0, 1.5), uniform.between(0.0, 6.0));
        const vec3 b = from_angles(uniform.between(0.0, 1.5), uniform.between(0.0, 6.0));
        const Metallic m = {vec3(0.9, 0.5, 0.1), 1.0, vec2(uniform.between(0.05, 1.0)), vec3(0.0), 1.0};
        const vec3 there = brdf_metallic(m, vec2(0.7, 0.1), vec3(0, 0, 1), a, b);
        const vec3 back = brdf_metallic(m, vec2(0.7, 0.1), vec3(0, 0, 1), b, a);
        EXPECT_LE(distance(there, back), 1e-12 * distance(there, vec3(0.0)));
    }
}

} // namespace
} // namespace lambent::test
