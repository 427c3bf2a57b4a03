// The samples of a GGX lobe, in double, against quadrature over the lobe's definition.
#include "tests/equations/directions.h"
#include "tests/equations/reference_ggx.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lambent::in_double {
namespace {

// Dark but for one lamp: the samples themselves are tested apart.
struct Environment {
    vec3 lamp{0.0, 0.0, 1.0};
    vec2 variances{1.0e-6, 4.0e-6}; // of the last level with the lamp and of the first without
};
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
int lamp_count(const Environment&)
{
    return 1;
}
vec3 lamp_direction(const Environment& e, int)
{
    return e.lamp;
}
vec3 lamp_light(const Environment&, int)
{
    return {1.0, 2.0, 3.0};
}
vec2 lamp_variances(const Environment& e)
{
    return e.variances;
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
                    const Mirror mirror = {{0.0, 0.0, 1.0}, V,         {0.0, 1.0, 0.0}, alpha,
                                           vec3(0.0),       vec3(0.0), {0.7, 0.2}};
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

// A lamp that all blurs hold is not added again.
TEST(SpecularGgx, LampsInTheBlursAreLeftToThem)
{
    const Mirror mirror = {{0.0, 0.0, 1.0}, view_at(0.7), {0.0, 1.0, 0.0}, 0.3,
                           vec3(0.0),       vec3(0.0),    {0.7, 0.2}};
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
    const Footprint footprint = footprint_of({N, V, aside, 0.1, dx, dy, {1.0, 0.1}});
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
    const Mirror mirror = {{0.0, 0.0, 1.0}, V, aside, alpha, width * aside, width * up, {albedo, 0.0}};
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

} // namespace lambent::in_double
