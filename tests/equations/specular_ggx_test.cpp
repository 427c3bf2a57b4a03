// The samples of a GGX lobe, in double, against quadrature over the lobe's definition.
#include "tests/equations/directions.h"
#include "tests/equations/reference_ggx.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lambent::in_double {
namespace {

// Hooks that only let the text compile: the samples themselves are tested.
struct Environment {};
struct LightSum {};
int sample_count(const Environment&)
{
    return 1;
}
vec3 cap_point(const Environment&, int)
{
    return vec3(0.5, 1.0, 0.0);
}
vec2 pixel_point(const Environment&, int)
{
    return vec2(0.0);
}
Real level_one_variance(const Environment&)
{
    return 1.0;
}
LightSum no_light(const Environment&)
{
    return {};
}
LightSum with_light(const Environment&, LightSum, vec3, Real, vec2)
{
    return {};
}
vec3 first_light(const Environment&, LightSum)
{
    return vec3(0.0);
}
vec3 second_light(const Environment&, LightSum)
{
    return vec3(0.0);
}

// The samples are tested, not the pass that adds them up.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include "shading/specular_ggx.glsl"
#pragma GCC diagnostic pop

} // namespace

// Means over the lobe: of the direction, and of z^2.
struct Moments {
    double x, y, z, z2;
};

vec3 view_at(double NV)
{
    return {std::sqrt((1.0 - NV) * (1.0 + NV)), 0.0, NV};
}

// By the sunflower spiral, each sample blurred: a Gaussian of variance v per axis takes exp(-v) from a direction's
// first moment and exp(-3 v) from its second.
Moments sampled_moments(double NV, double alpha, int samples)
{
    const LobeSampling lobe = lobe_sampling(view_at(NV), alpha, 1.0 / samples);
    Moments m{};
    double weights = 0.0;
    for (int i = 0; i < samples; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / std::numbers::phi;
        const LobeSample s =
            lobe_sample(lobe, vec3((i + 0.4) / (samples + 1.0), std::cos(turn), std::sin(turn)));
        const vec3 d = normalize(s.direction);
        const double first = s.weight * std::exp(-s.variance), third = std::exp(-3.0 * s.variance);
        m.x += first * d.x;
        m.y += first * d.y;
        m.z += first * d.z;
        m.z2 += s.weight * (1.0 / 3.0 + third * (d.z * d.z - 1.0 / 3.0));
        weights += s.weight;
    }
    return {m.x / weights, m.y / weights, m.z / weights, m.z2 / weights};
}

// By D and Smith's G2 from their definitions, over the hemisphere.
Moments true_moments(double NV, double alpha)
{
    constexpr int rows = 600, columns = 720;
    const vec3 V = view_at(NV);
    const auto lambda = [alpha](double c) {
        return 0.5 * (std::sqrt(1.0 + alpha * alpha * (1.0 - c * c) / (c * c)) - 1.0);
    };
    Moments m{};
    double weights = 0.0;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double z = (i + 0.5) / rows, r = std::sqrt(1.0 - z * z),
                         phi = 2.0 * std::numbers::pi * (j + 0.5) / columns;
            const vec3 L(r * std::cos(phi), r * std::sin(phi), z);
            const vec3 h = normalize(L + V);
            const double q = h.z * h.z * (alpha * alpha - 1.0) + 1.0;
            const double weight = 1.0 / (q * q) / (1.0 + lambda(z) + lambda(NV)); // D G2 but for constants
            m.x += weight * L.x;
            m.y += weight * L.y;
            m.z += weight * z;
            m.z2 += weight * z * z;
            weights += weight;
        }
    return {m.x / weights, m.y / weights, m.z / weights, m.z2 / weights};
}

double difference(const Moments& a, const Moments& b)
{
    return std::max(std::hypot(a.x - b.x, a.y - b.y, a.z - b.z), std::abs(a.z2 - b.z2));
}

// Wide, bounded and moved as they are, many samples are the lobe.
TEST(SpecularGgx, ManySamplesHaveTheLobesMoments)
{
    for (double alpha : {0.1, 0.25, 0.5, 1.0})
        for (double NV : {0.2, 0.5, 0.8, 1.0})
            EXPECT_LT(difference(sampled_moments(NV, alpha, 20000), true_moments(NV, alpha)), 0.003)
                << "alpha " << alpha << ", NV " << NV;
}

// Nor do the blurs of forty spread it by much. Samples left where they were drawn are off by up to 0.041.
TEST(SpecularGgx, BlursOfFortySamplesHardlyWidenTheLobe)
{
    for (double alpha : {0.1, 0.25, 0.5, 1.0})
        for (double NV : {0.2, 0.5, 0.8, 1.0})
            EXPECT_LT(difference(sampled_moments(NV, alpha, 40), true_moments(NV, alpha)), 0.025)
                << "alpha " << alpha << ", NV " << NV;
}

// What is not drawn is mirrored to below the horizon; of the roughest surface seen head on that is half.
TEST(SpecularGgx, FacetsLeftOutMirrorNothing)
{
    EXPECT_NEAR(reflecting_share_ggx(view_at(1.0), 1.0), 0.5, 1e-12);
    EXPECT_NEAR(reflecting_share_ggx(view_at(0.5), 1e-6), 1.0, 1e-9);
    for (double alpha : {0.05, 0.3, 0.7, 1.0})
        for (double NV : {0.05, 0.4, 0.8, 1.0}) {
            const vec3 V = view_at(NV), stretched = stretched_view(V, alpha);
            const double share = reflecting_share_ggx(V, alpha);
            for (int i = 0; i < 2000; ++i) {
                const double turn = 2.4 * i, xi2 = share + (1.0 - share) * (i + 0.5) / 2000;
                const vec3 h =
                    sample_visible_ggx(stretched, alpha, vec3(xi2, std::cos(turn), std::sin(turn))).normal;
                ASSERT_LT(2.0 * dot(V, h) * h.z - V.z, 1e-9) << alpha << " " << NV << " " << xi2;
            }
        }
}

} // namespace lambent::in_double
