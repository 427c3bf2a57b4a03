// Materials at a point: densities by quadrature over the whole sphere, draws by chi-square, light by both.
#include "reference/material.h"
#include "tests/support/chi_square.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

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

Integrals integrals(const Reflection& reflection, const Around& around)
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

Drawn drawn(const Reflection& reflection, const Around& around)
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

// All that is asked of a material; its albedo for this view.
double check(const Surface& surface, view::Model model)
{
    const Reflection reflection(surface, model, true);
    const Around around(surface);
    const Integrals expected = integrals(reflection, around);
    EXPECT_NEAR(expected.all, 1.0, 2e-3);
    const Drawn seen = drawn(reflection, around);
    std::vector<double> probabilities = expected.density;
    for (double& p : probabilities)
        p /= expected.all;
    EXPECT_TRUE(test::follows(seen.counted, probabilities));
    EXPECT_NEAR(seen.mean, expected.value, 5.0 * seen.deviation + 1e-3 * expected.value);
    return expected.value;
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

// Seen and lit the other way round a BRDF is the same; without compensation, which is not reciprocal.
TEST(ReferenceMaterial, IsReciprocal)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int i = 0; i < 200; ++i) {
        const auto direction = [&] {
            const glm::dvec3 d(uniform(random), uniform(random), uniform(random));
            return glm::normalize(glm::dvec3(d.x, d.y, std::fabs(d.z) + 0.05));
        };
        Surface there = surface_seen_at(1.0), back = there;
        there.material.base_color = back.material.base_color = {0.3, 0.6, 0.9};
        there.material.metallic = back.material.metallic = 1.0;
        there.material.alpha = back.material.alpha = 0.3;
        there.view = direction(), back.view = direction();
        const double one = Reflection(there, view::Model::ggx, false).value(back.view).x / back.view.z;
        const double other = Reflection(back, view::Model::ggx, false).value(there.view).x / there.view.z;
        EXPECT_NEAR(one, other, 1e-9 * (one + other) + 1e-15);
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

} // namespace
} // namespace lambent::reference
