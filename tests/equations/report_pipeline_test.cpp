// The report's own order of things, in double: its tone curve, its ambient and its specular pass, written out with powers.
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

using in_double::ReportTone;
using std::numbers::pi;

constexpr ReportTone linear = {2.2, 70.0, 1.3 / 2.2, 1.0 / 2.2}, nonlinear = {1.0, 70.0, 1.3, 1.0};

double toned(const ReportTone& t, double read)
{
    const double c = t.exposure * std::pow(read, t.decode);
    return std::pow(c / (c + 1.0), t.encode);
}

TEST(ReportPipeline, ValuesAreDecodedExposedBentAndEncoded)
{
    for (const ReportTone& t : {linear, nonlinear})
        for (const double read : {0.0, 1e-3, 0.02, 0.3, 1.0, 7.0, 500.0}) {
            const vec3 c = in_double::toned_report(t, vec3(read, 2.0 * read, 0.1 * read));
            EXPECT_NEAR(c.x, toned(t, read), 1e-12) << read;
            EXPECT_NEAR(c.y, toned(t, 2.0 * read), 1e-12) << read;
            EXPECT_NEAR(c.z, toned(t, 0.1 * read), 1e-12) << read;
        }
    // What overflows is white.
    EXPECT_EQ(in_double::toned_report({2.2, 7000.0, 1.0 / 2.2, 1.0}, vec3(1e30)).x, 1.0);
}

TEST(ReportPipeline, AmbientLightIsOfDecodedColoursAndTonedIrradiance)
{
    const vec3 diffuse(0.2, 0.5, 1.0), irradiance(3.0, 0.4, 0.01);
    for (const ReportTone& t : {linear, nonlinear}) {
        const vec3 c = in_double::ambient_report(t, diffuse, irradiance, 2.0);
        EXPECT_NEAR(c.x, std::pow(0.2, t.decode) / pi * toned(t, 3.0) * 2.0, 1e-12);
        EXPECT_NEAR(c.y, std::pow(0.5, t.decode) / pi * toned(t, 0.4) * 2.0, 1e-12);
        EXPECT_NEAR(c.z, 1.0 / pi * toned(t, 0.01) * 2.0, 1e-12);
    }
}

double cosine_between(const vec3& a, const vec3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

// Of what was read: levels of 1/2 log2(W H / N) - 1/2 log2 D(H), and the mean of F / 4 / (w.H)^2 * colour * max(N.w, 0).
TEST(ReportPipeline, SpecularLightIsTheReportsSum)
{
    int lit = 0, above = 0;
    for (const ReportTone& t : {linear, nonlinear})
        for (const double exponent : {1.0, 20.0, 625.0, 15625.0})
            for (const double angle : {0.0, 0.7, 1.3}) {
                std::vector<in_double::Lookup> lookups;
                const in_double::Environment e = {40, 1024.0, 512.0, 1.5e-4, &lookups};
                const in_double::Phong p = {vec3(0.0), vec3(0.04, 0.5, 1.0), exponent};
                const vec3 N = from_angles(1.0, 2.0), V = from_angles(1.0 + angle, 2.0);
                const vec3 result = in_double::specular_pipeline_report(e, t, p, N, V, vec3(0.0, 0.6, 0.8));
                ASSERT_EQ(lookups.size(), 40u);
                double sum[3] = {};
                for (const in_double::Lookup& l : lookups) {
                    const double NL = cosine_between(N, l.direction);
                    if (NL <= 0.0)
                        continue;
                    const vec3 both(l.direction.x + V.x, l.direction.y + V.y, l.direction.z + V.z);
                    const double length = std::sqrt(cosine_between(both, both));
                    const double NH = cosine_between(N, both) / length, LH = cosine_between(V, both) / length;
                    const double D = (exponent + 2.0) / (2.0 * pi) * std::pow(NH, exponent);
                    const double level = 0.5 * std::log2(1024.0 * 512.0 / 40.0) - 0.5 * std::log2(D);
                    EXPECT_NEAR(l.level, std::max(level, 0.0), 1e-6) << exponent;
                    above += level > 0.0;
                    const vec3 read = in_double::radiance(l.direction, l.level);
                    const double Ks[] = {0.04, 0.5, 1.0}, values[] = {read.x, read.y, read.z};
                    for (int k = 0; k < 3; ++k)
                        sum[k] += (Ks[k] + (1.0 - Ks[k]) * std::pow(1.0 - LH, 5.0)) / 4.0 / (LH * LH) *
                                  toned(t, values[k]) * NL / 40.0;
                }
                EXPECT_NEAR(result.x, std::pow(sum[0], t.back), 1e-6);
                EXPECT_NEAR(result.y, std::pow(sum[1], t.back), 1e-6);
                EXPECT_NEAR(result.z, std::pow(sum[2], t.back), 1e-6);
                lit += result.y > 0.01;
            }
    EXPECT_EQ(lit, 24);
    EXPECT_GT(above, 300);
}

TEST(ReportPipeline, LevelOfTheLobesMiddle)
{
    const in_double::Environment e = {40, 1024.0, 512.0, 1.5e-4, nullptr};
    for (const double a : {1.0, 625.0, 15625.0, 1e6}) {
        const double D = (a + 2.0) / (2.0 * pi);
        EXPECT_NEAR(in_double::middle_level_pipeline(e, a),
                    std::max(0.5 * std::log2(1024.0 * 512.0 / 40.0) - 0.5 * std::log2(D), 0.0), 1e-9);
    }
}

} // namespace
} // namespace lambent::test
