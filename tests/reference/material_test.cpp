// Materials at a point: densities by quadrature over the whole sphere, draws by chi-square, light by both.
#include "reference/material.h"
#include "tests/equations/reference_ggx.h"
#include "tests/reference/closed_phong.h"
#include "tests/support/chi_square.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace lambent::reference {
namespace {

using std::numbers::pi;

constexpr int bins = 16, fine_angle = 48, fine_turn = 24, draws = 30000;

Surface surface_seen_at(double NV)
{
    Surface s;
    s.geometric = s.normal = {0.0, 0.0, 1.0};
    s.view = {std::sqrt(1.0 - NV * NV), 0.0, NV};
    return s;
}

// Coordinates about the mirrored direction that spread a narrow highlight out: 1 - cosine = t^4, and the turn.
class Around {
public:
    explicit Around(const Surface& s)
        : axis_(-s.view.x, -s.view.y, s.view.z), across_(glm::normalize(glm::dvec3(axis_.z, 0.0, -axis_.x))),
          other_(glm::cross(axis_, across_))
    {
    }
    static double furthest() { return std::pow(2.0, 0.25); }
    glm::dvec3 direction(double t, double turn) const
    {
        const double less = t * t * t * t, sine = std::sqrt(less * (2.0 - less));
        return (1.0 - less) * axis_ + sine * (std::cos(turn) * across_ + std::sin(turn) * other_);
    }
    std::size_t bin(const glm::dvec3& d) const
    {
        const glm::dvec3 off = d - axis_; // 1 - cosine without loss of digits
        const double t = std::pow(0.5 * glm::dot(off, off), 0.25);
        const double turn = std::atan2(glm::dot(d, other_), glm::dot(d, across_)) + pi;
        const auto of = [](double x) { return std::clamp(static_cast<int>(x * bins), 0, bins - 1); };
        return static_cast<std::size_t>(of(t / furthest()) * bins + of(turn / (2.0 * pi)));
    }

private:
    glm::dvec3 axis_, across_, other_;
};

struct Integrals {
    std::vector<double> density = std::vector<double>(bins * bins, 0.0); ///< by bin
    double all = 0.0;                                                    ///< of the density
    double value = 0.0;                                                  ///< of green
};

template <class Lobe>
Integrals integrals(const Lobe& reflection, const Around& around)
{
    Integrals sum;
    const double dt = Around::furthest() / (bins * fine_angle), dturn = 2.0 * pi / (bins * fine_turn);
    for (int i = 0; i < bins * fine_angle; ++i)
        for (int k = 0; k < bins * fine_turn; ++k) {
            const double t = (i + 0.5) * dt;
            const glm::dvec3 d = around.direction(t, (k + 0.5) * dturn - pi);
            const double angle = 4.0 * t * t * t * dt * dturn, density = reflection.density(d) * angle;
            sum.density[static_cast<std::size_t>(i / fine_angle * bins + k / fine_turn)] += density;
            sum.all += density;
            sum.value += reflection.value(d).y * angle;
        }
    return sum;
}

struct Drawn {
    std::vector<double> counted = std::vector<double>(bins * bins, 0.0);
    double mean = 0.0, deviation = 0.0; ///< of green over density
};

template <class Lobe>
Drawn drawn(const Lobe& reflection, const Around& around)
{
    Drawn result;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform;
    double squares = 0.0;
    for (int i = 0; i < draws; ++i) {
        const double first = uniform(random);
        const glm::dvec3 d = reflection.draw({first, uniform(random)});
        EXPECT_NEAR(glm::length(d), 1.0, 1e-9);
        ++result.counted[around.bin(d)];
        const double density = reflection.density(d), value = reflection.value(d).y;
        EXPECT_TRUE(density > 0.0 || value == 0.0);
        const double worth = value > 0.0 ? value / density : 0.0;
        result.mean += worth / draws;
        squares += worth * worth / draws;
    }
    result.deviation = std::sqrt(std::max(squares - result.mean * result.mean, 0.0) / draws);
    return result;
}

// All that is asked of a lobe seen so; its albedo for this view.
template <class Lobe>
double check_lobe(const Lobe& lobe, const Surface& seen_as)
{
    const Around around(seen_as);
    const Integrals expected = integrals(lobe, around);
    EXPECT_NEAR(expected.all, 1.0, 2e-3);
    const Drawn seen = drawn(lobe, around);
    std::vector<double> probabilities = expected.density;
    for (double& p : probabilities)
        p /= expected.all;
    EXPECT_TRUE(test::follows(seen.counted, probabilities));
    EXPECT_NEAR(seen.mean, expected.value, 5.0 * seen.deviation + 1e-3 * expected.value);
    return expected.value;
}

double check(const Surface& surface, view::Model model)
{
    return check_lobe(Reflection(surface, model, true), surface);
}

TEST(ReferenceMaterial, GgxDrawsByItsDensity)
{
    for (const double alpha : {0.01, 0.1, 0.5, 1.0})
        for (const double metalness : {0.0, 0.5, 1.0})
            for (const double NV : {0.05, 0.4, 0.999}) {
                SCOPED_TRACE(::testing::Message()
                             << "alpha " << alpha << ", metalness " << metalness << ", NV " << NV);
                Surface s = surface_seen_at(NV);
                s.material.base_color = {0.3, 0.6, 0.9};
                s.material.metallic = metalness;
                s.material.alpha = alpha;
                check(s, view::Model::ggx);
            }
}

TEST(ReferenceMaterial, PhongDrawsByItsDensity)
{
    for (const double exponent : {0.1, 1.0, 10.0, 1e3, 1e5})
        for (const double NV : {0.05, 0.4, 0.999}) {
            // Where the lobe is as wide as the view is steep, its pole at -V is too narrow for this quadrature.
            if (exponent == 1e3 && NV < 0.1)
                continue;
            SCOPED_TRACE(::testing::Message() << "exponent " << exponent << ", NV " << NV);
            Surface s = surface_seen_at(NV);
            s.phong = {{0.3, 0.6, 0.9}, {0.2, 0.1, 0.05}, exponent};
            check(s, view::Model::phong);
        }
}

TEST(ReferenceMaterial, WhiteMetalReflectsAllLight)
{
    for (const double alpha : {0.01, 0.1, 0.3, 0.6, 1.0})
        for (const double NV : {0.05, 0.2, 0.5, 0.999}) {
            SCOPED_TRACE(::testing::Message() << "alpha " << alpha << ", NV " << NV);
            Surface s = surface_seen_at(NV);
            s.material.base_color = glm::dvec3(1.0);
            s.material.metallic = 1.0;
            s.material.alpha = alpha;
            EXPECT_NEAR(check(s, view::Model::ggx), 1.0, 5e-3);
        }
}

TEST(ReferenceMaterial, NothingIsReflectedFromBelow)
{
    Surface s = surface_seen_at(0.5);
    s.material.base_color = s.phong.diffuse = glm::dvec3(0.5);
    for (const view::Model model : {view::Model::ggx, view::Model::phong})
        EXPECT_EQ(Reflection(s, model, true).value(glm::normalize(glm::dvec3(-0.8, 0.1, -0.01))),
                  glm::dvec3(0.0));
}

// BRDF times the cosine of facets alone, without what is scattered more than once, from another form of the formulas.
double facets_witness(double alpha, double F0, const glm::dvec3& N, const glm::dvec3& V, const glm::dvec3& L)
{
    const glm::dvec3 H = glm::normalize(V + L);
    const double NL = glm::dot(N, L), NV = glm::dot(N, V), NH = glm::dot(N, H);
    const double schlick = F0 + (1.0 - F0) * std::pow(1.0 - glm::dot(V, H), 5.0);
    const double G = 1.0 / (1.0 + test::smith_lambda(NL, alpha) + test::smith_lambda(NV, alpha));
    return schlick * test::facet_density(NH, alpha) * G / (4.0 * NV);
}

// Integral over the hemisphere about z, by its midpoints.
template <class F>
double over_hemisphere(const F& value)
{
    constexpr int steps = 400;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
        for (int k = 0; k < steps; ++k) {
            const double z = (i + 0.5) / steps, turn = 2.0 * pi * (k + 0.5) / steps;
            const double r = std::sqrt(1.0 - z * z);
            sum += value(glm::dvec3(r * std::cos(turn), r * std::sin(turn), z));
        }
    return sum * 2.0 * pi / (steps * steps);
}

// A witness for every lobe of the lists: BRDF times cosine of it alone, in green. A lobe without one does not build.

// Metal and dielectric; what the facets of the latter do not send, the diffuse base below does.
double witness_ggx(double alpha, const Surface& s, const glm::dvec3& light)
{
    const glm::dvec3 z(0.0, 0.0, 1.0),
        view(std::sqrt(1.0 - std::pow(glm::dot(s.normal, s.view), 2)), 0.0, glm::dot(s.normal, s.view));
    static std::map<std::pair<double, double>, double> albedos;
    const auto [albedo, is_new] = albedos.try_emplace({alpha, view.z}, 0.0);
    if (is_new)
        albedo->second =
            over_hemisphere([&](const glm::dvec3& L) { return facets_witness(alpha, 0.04, z, view, L); });
    const double m = s.material.metallic, base = s.material.base_color.y;
    const double diffuse = base * (1.0 - albedo->second) * glm::dot(s.normal, light) / pi;
    return m * facets_witness(alpha, base, s.normal, s.view, light) +
           (1.0 - m) * (facets_witness(alpha, 0.04, s.normal, s.view, light) + diffuse);
}

double witness_phong(double /*alpha*/, const Surface& s, const glm::dvec3& light)
{
    const testing::ClosedPhong closed{s.phong.diffuse.y, s.phong.specular.y, s.phong.exponent};
    return closed.brdf(s.normal, s.view, light) * glm::dot(s.normal, light);
}

double witness_coat(double alpha, const Surface& s, const glm::dvec3& light)
{
    return facets_witness(alpha, 0.04, s.layers.at(0).normal, s.view, light);
}

struct ListedLobe {
    const char* name;
    view::Model model;
    int layer; ///< 0: a base
    double PointMaterial::*there;
    double PointMaterial::*alpha;
    double (*witness)(double alpha, const Surface& surface, const glm::dvec3& light);
};

constexpr ListedLobe listed_bases[] = {
#define BASE(name, number, layered)                                                                          \
    {#name, view::Model::name, 0, nullptr, &PointMaterial::alpha, witness_##name},
#include "shading/passes/bases.h"
};

constexpr ListedLobe listed_layers[] = {
#define LAYER(name, number, normal)                                                                          \
    {#name, view::Model::ggx, number, &PointMaterial::name, &PointMaterial::name##_alpha, witness_##name},
#include "shading/lobes/layers.h"
};

std::vector<ListedLobe> listed_lobes()
{
    std::vector<ListedLobe> all(std::begin(listed_bases), std::end(listed_bases));
    all.insert(all.end(), std::begin(listed_layers), std::end(listed_layers));
    return all;
}

// A coloured, half metallic base, or the lobe over one whose own normal is another than the lobe's.
Surface surface_of(const ListedLobe& lobe, double alpha, double NV)
{
    Surface s = surface_seen_at(NV);
    s.material.base_color = {0.3, 0.6, 0.9};
    s.material.metallic = 0.5;
    s.material.alpha = 0.4;
    s.material.*lobe.alpha = alpha;
    s.phong = {{0.3, 0.6, 0.9}, {0.2, 0.1, 0.05}, std::max(2.0 / (alpha * alpha) - 2.0, 0.1)};
    if (lobe.layer == 0)
        return s;
    s.layers = {{lobe.layer, s.normal}};
    s.normal = glm::normalize(glm::dvec3(0.1, 0.2, 1.0));
    s.material.*lobe.there = 1.0;
    return s;
}

// What the lobe sends itself: of one over the base, all but what is seen of the base through it.
glm::dvec3 own_value(const ListedLobe& lobe, const Surface& s, const glm::dvec3& light)
{
    const glm::dvec3 all = Reflection(s, lobe.model, false).value(light);
    if (lobe.layer == 0)
        return all;
    Surface bare = s, shining = s;
    bare.layers.clear();
    bare.material.*lobe.there = 0.0;
    shining.material.emissive = glm::dvec3(1.0);
    return all - emitted_by(shining, false) * Reflection(bare, lobe.model, false).value(light);
}

std::vector<glm::dvec3> directions_above(int count)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform;
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < count; ++i) {
        const double z = 0.05 + 0.95 * uniform(random), turn = 2.0 * pi * uniform(random);
        const double r = std::sqrt(1.0 - z * z);
        directions.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
    }
    return directions;
}

TEST(ReferenceLobes, AreDrawnByTheirDensity)
{
    for (const ListedLobe& lobe : listed_lobes())
        for (const double alpha : {0.02, 0.3, 1.0})
            for (const double there : {0.3, 1.0}) {
                SCOPED_TRACE(::testing::Message() << lobe.name << " " << there << ", alpha " << alpha);
                Surface s = surface_of(lobe, alpha, 0.6);
                if (lobe.layer != 0) {
                    s.normal = s.layers[0].normal; // where check()'s grid is fine
                    s.material.*lobe.there = there;
                }
                check(s, lobe.model);
            }
}

TEST(ReferenceLobes, AreTheirWitness)
{
    for (const ListedLobe& lobe : listed_lobes())
        for (const double alpha : {0.1, 0.4, 1.0})
            for (const glm::dvec3& light : directions_above(50)) {
                const Surface s = surface_of(lobe, alpha, 0.7);
                const double expected = lobe.witness(alpha, s, light);
                // The diffuse base knows the facets' albedo from a table.
                const double table = lobe.layer == 0 && lobe.model == view::Model::ggx ? 3e-3 : 1e-6;
                EXPECT_NEAR(own_value(lobe, s, light).y, expected, 1e-9 + table * expected) << lobe.name;
            }
}

// Seen and lit the other way round a lobe is the same; but for a diffuse base under facets, which here are metal.
TEST(ReferenceLobes, AreReciprocal)
{
    for (const ListedLobe& lobe : listed_lobes())
        for (const glm::dvec3& light : directions_above(50)) {
            Surface there = surface_of(lobe, 0.3, 0.7);
            there.material.metallic = 1.0;
            Surface back = there;
            back.view = light;
            const double one = own_value(lobe, there, light).x / light.z;
            const double other = own_value(lobe, back, there.view).x / there.view.z;
            EXPECT_NEAR(one, other, 1e-9 + 1e-6 * std::fabs(one)) << lobe.name;
        }
}

// What a lobe sends on of white light is the integral of its witness: table and draws against quadrature.
TEST(ReferenceLobes, SendWhatTheirWitnessDoes)
{
    for (const ListedLobe& lobe : listed_lobes())
        for (const double alpha : {0.2, 0.6, 1.0})
            for (const double NV : {0.15, 0.5, 0.95}) {
                Surface s = surface_of(lobe, alpha, NV);
                s.material.emissive = glm::dvec3(1.0);
                const double albedo =
                    over_hemisphere([&](const glm::dvec3& L) { return lobe.witness(alpha, s, L); });
                const double own =
                    lobe.layer == 0
                        ? over_hemisphere([&](const glm::dvec3& L) { return own_value(lobe, s, L).y; })
                        : 1.0 - emitted_by(s, false).x; // what it does not leave to those below
                EXPECT_NEAR(own, albedo, 3e-3) << lobe.name << ", alpha " << alpha << ", NV " << NV;
            }
}

// White light that a lobe does not send back itself it leaves to what is below, which here is a white metal; the report's
// model alone loses some.
TEST(ReferenceLobes, LoseNoLight)
{
    for (const ListedLobe& lobe : listed_lobes())
        for (const double alpha : {0.05, 0.5, 1.0})
            for (const double NV : {0.1, 0.5, 0.999}) {
                if (lobe.model == view::Model::phong)
                    continue;
                Surface s = surface_of(lobe, alpha, NV);
                if (lobe.layer != 0)
                    s.normal = s.layers[0].normal;
                s.material.base_color = glm::dvec3(1.0);
                s.material.metallic = lobe.layer != 0 ? 1.0 : 0.5;
                EXPECT_NEAR(check(s, lobe.model), 1.0, 6e-3) << lobe.name << ", alpha " << alpha;
            }
}

// A white metal whose facets are stretched, its tangent at 30 degrees to the plane of view.
Facets stretched_facets(const glm::dvec2& alpha, double NV)
{
    const Surface s = surface_seen_at(NV);
    Facets f;
    f.normal = s.normal, f.view = s.view;
    f.base = glm::dvec3(1.0), f.metalness = 1.0;
    f.alpha = alpha, f.tangent = {std::cos(pi / 6.0), std::sin(pi / 6.0), 0.0};
    f.compensation = 0.0;
    f.albedo = {0.7, 0.1};
    return f;
}

TEST(ReferenceFacets, StretchedTheyAreDrawnByTheirDensity)
{
    for (const glm::dvec2 alpha : {glm::dvec2(0.6, 0.1), glm::dvec2(0.15, 0.5), glm::dvec2(1.0, 0.3)})
        for (const double NV : {0.2, 0.6, 0.999}) {
            SCOPED_TRACE(::testing::Message() << "alpha " << alpha.x << ' ' << alpha.y << ", NV " << NV);
            EXPECT_LT(check_lobe(stretched_facets(alpha, NV), surface_seen_at(NV)), 1.0);
        }
}

// By slopes p along the tangent and q along the bitangent: D = 1 / (pi ax ay (1 + p^2 / ax^2 + q^2 / ay^2)^2) over the fourth
// power of the cosine, and Smith's Lambda is that of the alpha along a direction's azimuth. [Heitz 2014, eq. 80 and 84]
TEST(ReferenceFacets, StretchedTheyAreTheirSlopes)
{
    for (const glm::dvec2 alpha : {glm::dvec2(0.6, 0.1), glm::dvec2(0.15, 0.5)})
        for (const glm::dvec3& light : directions_above(50)) {
            const Facets f = stretched_facets(alpha, 0.7);
            const glm::dvec3 T = f.tangent, B = glm::cross(f.normal, T), H = glm::normalize(f.view + light);
            const double p = glm::dot(T, H) / H.z, q = glm::dot(B, H) / H.z;
            const double slopes = 1.0 + p * p / (alpha.x * alpha.x) + q * q / (alpha.y * alpha.y);
            const double D = 1.0 / (pi * alpha.x * alpha.y * slopes * slopes * std::pow(H.z, 4.0));
            const auto lambda = [&](const glm::dvec3& w) {
                const double azimuth = std::atan2(glm::dot(B, w), glm::dot(T, w));
                return test::smith_lambda(
                    w.z, std::hypot(alpha.x * std::cos(azimuth), alpha.y * std::sin(azimuth)));
            };
            const double expected = D / (1.0 + lambda(light) + lambda(f.view)) / (4.0 * f.view.z);
            EXPECT_NEAR(f.value(light).x, expected, 1e-9 * expected);
            Facets back = f;
            back.view = light;
            EXPECT_NEAR(back.value(f.view).x / f.view.z, f.value(light).x / light.z,
                        1e-9 * expected / light.z);
        }
}

// Facets that are hardly stretched are those that are not.
TEST(ReferenceFacets, TwoEqualNumbersAreOne)
{
    const Facets one = stretched_facets({0.3, 0.3}, 0.6), two = stretched_facets({0.3, 0.3 + 1e-9}, 0.6);
    EXPECT_FALSE(one.is_stretched());
    EXPECT_TRUE(two.is_stretched());
    for (const glm::dvec3& light : directions_above(20)) {
        EXPECT_NEAR(one.value(light).x, two.value(light).x, 1e-6 * one.value(light).x);
        EXPECT_NEAR(one.density(light), two.density(light), 1e-6 * one.density(light));
    }
}

} // namespace
} // namespace lambent::reference
