// The report's specular pass, in double: where it looks, how sharply, and what it makes of that, against docs/PHONG.md
// written out with powers and logarithms.
#include "tests/equations/directions.h"

#include <gtest/gtest.h>

#include <vector>

namespace lambent::in_double {
namespace {

#include "tests/equations/phong_hooks.h"

} // namespace
} // namespace lambent::in_double

namespace lambent::test {
namespace {

using in_double::Environment;
using in_double::Lookup;
using in_double::Phong;
using std::numbers::pi;

struct Looked {
    Environment environment;
    Phong material;
    vec3 N, V;
    std::vector<Lookup> lookups;
    vec3 result;
};

// A pass at five exponents, each from three views.
template <class Pass>
std::vector<Looked> look(Pass pass)
{
    std::vector<Looked> all;
    for (double exponent : {1.0, 20.0, 625.0, 15625.0, 390625.0})
        for (double angle : {0.0, 0.7, 1.3}) {
            Looked l = {{16, 1024.0, 512.0, 1.5e-4, nullptr},
                        {vec3(0.0), vec3(0.04, 0.5, 1.0), exponent},
                        from_angles(1.0, 2.0),
                        from_angles(1.0 + angle, 2.0),
                        {},
                        vec3(0.0)};
            l.environment.lookups = &l.lookups;
            l.result = pass(l.environment, l.material, l.N, l.V, vec3(0.0, 0.6, 0.8));
            l.environment.lookups = nullptr;
            all.push_back(l);
        }
    return all;
}

std::vector<Looked> look_as_report()
{
    return look([](auto... a) { return in_double::specular_phong_report(a...); });
}

std::vector<Looked> look_matched()
{
    return look([](const Environment& e, const Phong& p, vec3 N, vec3 V, vec3 across) {
        return in_double::specular_phong(e, p, {N, V, vec3(0.0), vec3(0.0)}, across);
    });
}

vec3 halfway(vec3 a, vec3 b)
{
    const vec3 sum(a.x + b.x, a.y + b.y, a.z + b.z);
    const double length = std::hypot(sum.x, sum.y, sum.z);
    return {sum.x / length, sum.y / length, sum.z / length};
}

// 1/2 log2(W H / N) - 1/2 log2(D(H) / 4), and never below the sharpest.
TEST(SpecularPhong, LevelsAreTheReports)
{
    int above = 0;
    for (const Looked& l : look_as_report()) {
        ASSERT_EQ(l.lookups.size(), 16u);
        for (const Lookup& lookup : l.lookups) {
            if (cosine_between(l.N, lookup.direction) <= 0.0)
                continue; // counts nothing, and may have no halfway direction above the surface
            const double NH = cosine_between(l.N, halfway(lookup.direction, l.V));
            const double D = (l.material.exponent + 2.0) / (2.0 * pi) * std::pow(NH, l.material.exponent);
            const double level = 0.5 * std::log2(1024.0 * 512.0 / 16.0) - 0.5 * std::log2(D / 4.0);
            EXPECT_NEAR(lookup.level, std::max(level, 0.0), 1e-6) << l.material.exponent;
            above += level > 0.0;
        }
    }
    EXPECT_GT(above, 150);
}

// A sample stands for 1 / (N density); a level is the blend of two Gaussians of variances v1 4^(l - 1), level 0 of
// v1 / 16; their share of a sample's solid angle is equations/footprint.glsl's 0.3.
TEST(SpecularPhong, MatchedLevelsAreAsWideAsTheShareOfTheLobe)
{
    for (const Looked& l : look_matched()) {
        ASSERT_EQ(l.lookups.size(), 16u);
        const vec3 R = in_double::mirrored(l.N, l.V);
        for (const Lookup& lookup : l.lookups) {
            const double a = l.material.exponent, cosine = cosine_between(R, lookup.direction);
            const double density = (a + 1.0) / (2.0 * pi) * std::pow(cosine, a);
            const double below = std::floor(lookup.level), part = lookup.level - below;
            const auto variance = [&](double level) {
                return level < 1.0 ? 1.0 / 16.0 : std::pow(4.0, level - 1.0);
            };
            const double blend = 1.5e-4 * ((1.0 - part) * variance(below) + part * variance(below + 1.0));
            if (lookup.level > 0.0)
                EXPECT_NEAR(blend / (0.3 / (16.0 * density)), 1.0, 1e-6) << a;
            else
                EXPECT_LE(0.3 / (16.0 * density), 1.5e-4 / 16.0 * 1.000001) << a;
        }
    }
}

// Of a lookup at the mirrored view, where the halfway direction is the normal.
TEST(SpecularPhong, LevelsOfTheLobesMiddle)
{
    const Environment e = {16, 1024.0, 512.0, 1.5e-4, nullptr};
    for (double a : {1.0, 20.0, 625.0, 15625.0}) {
        const double D = (a + 2.0) / (2.0 * pi);
        EXPECT_NEAR(in_double::middle_level_report(e, a),
                    std::max(0.5 * std::log2(1024.0 * 512.0 / 16.0) - 0.5 * std::log2(D / 4.0), 0.0), 1e-9);
        const double level = in_double::middle_level_phong(
                         e, {{0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, vec3(0.0), vec3(0.0)}, a),
                     below = std::floor(level);
        const auto variance = [](double l) { return l < 1.0 ? 1.0 / 16.0 : std::pow(4.0, l - 1.0); };
        const double blend = variance(below) + (level - below) * (variance(below + 1.0) - variance(below));
        EXPECT_NEAR(blend, std::max(0.3 * 2.0 * pi / (16.0 * (a + 1.0)) / 1.5e-4, 1.0 / 16.0), 1e-6 * blend);
    }
}

// About the mirrored view, at the cosine xi2^(1 / (alpha + 1)).
TEST(SpecularPhong, DirectionsAreTheLobes)
{
    for (const auto& all : {look_as_report(), look_matched()})
        for (const Looked& l : all) {
            const double NV = cosine_between(l.N, l.V);
            const vec3 R(2.0 * NV * l.N.x - l.V.x, 2.0 * NV * l.N.y - l.V.y, 2.0 * NV * l.N.z - l.V.z);
            for (int i = 0; i < 16; i++) {
                const double cosine =
                    std::pow(in_double::xi2_of(l.environment, i), 1.0 / (l.material.exponent + 1.0));
                EXPECT_NEAR(cosine_between(R, l.lookups[static_cast<size_t>(i)].direction), cosine, 1e-9);
            }
        }
}

// The average of F / (4 (w.H)^2) environment(w) max(N.w, 0).
TEST(SpecularPhong, ResultIsTheReportsAverage)
{
    for (const auto& all : {look_as_report(), look_matched()})
        for (const Looked& l : all) {
            vec3 mean(0.0);
            for (const Lookup& lookup : l.lookups) {
                const double wH = cosine_between(lookup.direction, halfway(lookup.direction, l.V));
                const double NL = std::max(cosine_between(l.N, lookup.direction), 0.0);
                const double grazing = std::pow(1.0 - wH, 5.0);
                const vec3 light = in_double::radiance(lookup.direction, lookup.level);
                const auto term = [&](double Ks, double radiance) {
                    return (Ks + (1.0 - Ks) * grazing) / (4.0 * wH * wH) * radiance * NL / 16.0;
                };
                mean = vec3(mean.x + term(0.04, light.x), mean.y + term(0.5, light.y),
                            mean.z + term(1.0, light.z));
            }
            EXPECT_LT(distance(l.result, mean), 1e-9 * distance(mean, vec3(0.0))) << l.material.exponent;
        }
}

// A lamp that no blur holds: the lobe's density there, (alpha + 1) / (2 pi) (R.w)^alpha, times what a sample weighs.
TEST(SpecularPhong, LampsAreSeenThroughTheLobe)
{
    for (const Looked& l : look_matched()) {
        in_double::Environment lit = l.environment;
        lit.lamps = 1;
        const vec3 R = in_double::mirrored(l.N, l.V);
        for (const vec3& towards : {R, R + 0.1 * l.V, R + 0.5 * l.N, vec3(0.3, -0.4, 0.2)}) {
            lit.lamp = in_double::normalize(towards);
            const double a = l.material.exponent, NL = std::max(cosine_between(l.N, lit.lamp), 0.0);
            const double density =
                (a + 1.0) / (2.0 * pi) * std::pow(std::max(cosine_between(R, lit.lamp), 0.0), a);
            const double wH = cosine_between(lit.lamp, halfway(lit.lamp, l.V));
            const double F = 0.04 + 0.96 * std::pow(1.0 - wH, 5.0);
            const double wanted = density * NL * F / (4.0 * wH * wH);
            const vec3 seen = in_double::lamps_phong(lit, l.material, {l.N, l.V, vec3(0.0), vec3(0.0)},
                                                     {0.0, 0.0, 0.0}, 1.0 / 16.0);
            EXPECT_NEAR(seen.x, wanted, 1e-6 * wanted + 1e-9) << a;
        }
    }
}

// Samples that move about in the pixel have, with the pixel's part of the blur, the variance of a pixel: a twelfth of its
// area along each side. What is left in the blur is that of samples of the pixel itself, 0.3 of its N-th part.
TEST(SpecularPhong, PlacesAndBlursHaveThePixelsVarianceTogether)
{
    const vec3 N(0.0, 0.0, 1.0), V(0.0, -0.6, 0.8), aside(1.0, 0.0, 0.0), up(0.0, 0.8, -0.6);
    for (double exponent : {1.0, 625.0, 390625.0})
        for (double width : {0.001, 0.02, 0.3}) {
            const in_double::PixelBlur blur =
                in_double::pixel_blur_phong({N, V, width * aside, width * up}, exponent, 1.0 / 16.0);
            const double area = width * width, share = 0.3 * area / 16.0;
            EXPECT_NEAR(blur.moved * blur.moved * area / 12.0 + blur.variance - share, area / 12.0,
                        1e-9 * area);
            EXPECT_EQ(blur.moved > 0.9, width > std::sqrt(9.0 * pi / (exponent + 1.0)))
                << exponent << ' ' << width;
        }
}

// What a pixel `width` wide sees of a sky of lamps, of radiance 1 in the first channel: by rings about the mirrored view,
// finer towards it.
double seen_of_a_white_sky(double exponent, double width)
{
    const vec3 N(0.0, 0.0, 1.0), V(0.0, -0.6, 0.8), R(0.0, 0.6, 0.8), aside(1.0, 0.0, 0.0),
        up(0.0, 0.8, -0.6);
    const in_double::ShinyPoint point = {N, V, width * aside, width * up};
    const in_double::PixelBlur blur = in_double::pixel_blur_phong(point, exponent, 1.0 / 16.0);
    Environment lit = {16, 1024.0, 512.0, 1.5e-4, nullptr};
    lit.lamps = 1;
    constexpr int rings = 400, steps = 48;
    double seen = 0.0;
    for (int i = 0; i < rings; ++i) {
        const double t = (i + 0.5) / rings, theta = 1.5 * t * t * t * t, wide = 6.0 * t * t * t / rings;
        for (int j = 0; j < steps; ++j) {
            const double phi = 2.0 * pi * (j + 0.5) / steps;
            lit.lamp = std::cos(theta) * R + std::sin(theta) * (std::cos(phi) * aside + std::sin(phi) * up);
            seen += std::sin(theta) * wide * 2.0 * pi / steps *
                    in_double::lamps_phong(lit, {vec3(0.0), vec3(1.0), exponent}, point, blur, 1.0 / 16.0).x;
        }
    }
    return seen;
}

// Through the lobe, the pixel or both it is a quarter over (w.H)^2, times N.w, at the mirrored view.
TEST(SpecularPhong, LampsAllAroundAreAWhiteSky)
{
    const double weight = 0.8 / (4.0 * 0.8 * 0.8);
    for (double exponent : {625.0, 15625.0, 390625.0})
        for (double width : {0.0, 0.003, 0.02, 0.06, 0.2})
            EXPECT_NEAR(seen_of_a_white_sky(exponent, width) / weight, 1.0, 0.04) << exponent << ' ' << width;
}

} // namespace
} // namespace lambent::test
