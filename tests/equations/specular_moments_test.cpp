// How wide the samples of a GGX lobe and their blurs are and where they lie, in double, against quadrature over the lobe's
// definition.
#include "tests/equations/directions.h"

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

// Means over the lobe: of the direction, and of z^2.
struct Moments {
    double x, y, z, z2;
};

// Point i of a sunflower spiral, as lobe_sample takes it.
vec3 spiral_point(int i, int samples)
{
    const double turn = 2.0 * std::numbers::pi * i / std::numbers::phi;
    return {(i + 0.4) / (samples + 1.0), std::cos(turn), std::sin(turn)};
}

// By the sunflower spiral, each sample blurred: a Gaussian of variance v per axis takes exp(-v) from a direction's
// first moment and exp(-3 v) from its second. Blurs are those of `blurs` samples.
Moments sampled_moments(double NV, double alpha, int samples, int blurs)
{
    const LobeSampling lobe = lobe_sampling(view_at(NV), vec2(alpha), 1.0 / blurs);
    Moments m{};
    double weights = 0.0;
    for (int i = 0; i < samples; ++i) {
        const LobeSample s = lobe_sample(lobe, spiral_point(i, samples));
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
            EXPECT_LT(difference(sampled_moments(NV, alpha, 20000, 20000), true_moments(NV, alpha)), 0.003)
                << "alpha " << alpha << ", NV " << NV;
}

// Second moments along either axis of a lobe that is stretched, seen along the normal: of the samples, and by slopes.
struct Spreads {
    double xx, yy;
};

Spreads sampled_spreads(vec2 alpha, int samples)
{
    const LobeSampling lobe = lobe_sampling(view_at(1.0), alpha, 1.0 / samples);
    Spreads sum{};
    double weights = 0.0;
    for (int i = 0; i < samples; ++i) {
        const LobeSample s = lobe_sample(lobe, spiral_point(i, samples));
        const vec3 d = normalize(s.direction);
        sum.xx += s.weight * d.x * d.x, sum.yy += s.weight * d.y * d.y;
        weights += s.weight;
    }
    return {sum.xx / weights, sum.yy / weights};
}

Spreads true_spreads(vec2 alpha)
{
    constexpr int rows = 1200, columns = 720;
    Spreads sum{};
    double weights = 0.0;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double z = (i + 0.5) / rows, r = std::sqrt(1.0 - z * z),
                         phi = 2.0 * std::numbers::pi * (j + 0.5) / columns;
            const vec3 L(r * std::cos(phi), r * std::sin(phi), z), h = normalize(L + vec3(0.0, 0.0, 1.0));
            const double q = std::pow(h.x / alpha.x, 2.0) + std::pow(h.y / alpha.y, 2.0) + h.z * h.z;
            const double a = std::hypot(alpha.x * std::cos(phi), alpha.y * std::sin(phi)), t = r / z;
            const double weight = 1.0 / (q * q) / (1.0 + 0.5 * (std::sqrt(1.0 + a * a * t * t) - 1.0));
            sum.xx += weight * L.x * L.x, sum.yy += weight * L.y * L.y;
            weights += weight;
        }
    return {sum.xx / weights, sum.yy / weights};
}

TEST(SpecularGgx, ManySamplesHaveAStretchedLobesSpreads)
{
    stretch = 1;
    for (const vec2 alpha : {vec2(0.6, 0.1), vec2(0.2, 0.5), vec2(0.3, 0.3)}) {
        const Spreads samples = sampled_spreads(alpha, 20000), lobe = true_spreads(alpha);
        EXPECT_NEAR(samples.xx, lobe.xx, 0.003) << alpha.x << ' ' << alpha.y;
        EXPECT_NEAR(samples.yy, lobe.yy, 0.003) << alpha.x << ' ' << alpha.y;
    }
    stretch = 0;
}

// Nor do the blurs of forty spread it by much. Samples left where they were drawn are off by up to 0.041.
TEST(SpecularGgx, BlursOfFortySamplesHardlyWidenTheLobe)
{
    for (double alpha : {0.1, 0.25, 0.5, 1.0})
        for (double NV : {0.2, 0.5, 0.8, 1.0})
            EXPECT_LT(difference(sampled_moments(NV, alpha, 40, 40), true_moments(NV, alpha)), 0.025)
                << "alpha " << alpha << ", NV " << NV;
}

// By moving samples up, the blur's first order is gone: what it does to the height of rough lobes falls with its square. Samples
// moved up by half of that would be off by 0.0033 and more at 160.
TEST(SpecularGgx, MovedSamplesLeaveOnlyTheSquareOfTheBlur)
{
    for (double alpha : {0.7, 1.0})
        for (double NV : {0.2, 0.5, 0.8, 1.0}) {
            constexpr int many = 20000;
            const double wanted = true_moments(NV, alpha).z;
            const double off = sampled_moments(NV, alpha, many, 160).z - wanted,
                         off_of_forty = sampled_moments(NV, alpha, many, 40).z - wanted;
            EXPECT_LT(std::abs(off), 0.0015) << alpha << ' ' << NV;
            EXPECT_LT(std::abs(off), 0.2 * std::abs(off_of_forty)) << alpha << ' ' << NV; // not a quarter
        }
}

// Places in a pixel are spread evenly over it, which has the variance of a twelfth of its area along each side. Samples that
// move by a part of the pixel have that part's; the rest of it is in their blur.
TEST(SpecularGgx, PlacesAndBlursHaveThePixelsVarianceTogether)
{
    const vec3 aside(0.0, 1.0, 0.0);
    for (double NV : {0.3, 1.0})
        for (double alpha : {0.001, 0.02, 0.1, 0.4, 1.0})
            for (double width : {0.001, 0.02, 0.1, 0.3})
                for (int samples : {8, 40}) {
                    const vec3 V = view_at(NV), R(-V.x, 0.0, V.z), up = cross(R, aside);
                    const LobeSampling lobe = lobe_sampling(V, vec2(alpha), 1.0 / samples);
                    const ShinyPoint point = {{0.0, 0.0, 1.0}, V, width * aside, width * up};
                    const PixelBlur blur = pixel_blur(point, lobe.variance, 1.0 / samples);
                    const double area = width * width, share = 0.3 * area / samples; // of one of the samples
                    EXPECT_NEAR(blur.moved * blur.moved * area / 12.0 + blur.variance - share, area / 12.0,
                                1e-9 * area)
                        << alpha << ' ' << width << ' ' << samples;
                    EXPECT_GE(blur.moved, 0.0);
                    EXPECT_LE(blur.moved, 1.0);
                }
}

} // namespace
} // namespace lambent::in_double
