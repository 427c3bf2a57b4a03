#include "tests/equations/directions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lambent::test {
namespace {

using in_double::agx_sigmoid;
using in_double::tone_aces;
using in_double::tone_agx;
using in_double::tone_linear;
using in_double::tone_neutral;
using in_double::tone_reinhard;

using Curve = vec3 (*)(vec3);

struct Named {
    const char* name;
    Curve curve;
};

constexpr Named curves[] = {{"reinhard", tone_reinhard},
                            {"linear", tone_linear},
                            {"neutral", tone_neutral},
                            {"aces", tone_aces},
                            {"agx", tone_agx}};

TEST(Tone, GreysRiseFromBlackToWhiteAndStayGrey)
{
    for (const auto& [name, curve] : curves) {
        double last = -1.0;
        for (int i = -1; i <= 2000; i++) {
            const double grey = i < 0 ? 0.0 : std::pow(10.0, -4.0 + i * 0.0045); // to 1e5
            const vec3 c = curve(vec3(grey));
            EXPECT_GE(c.y, last) << name << " " << grey;
            EXPECT_TRUE(c.y >= 0.0 && c.y <= 1.0) << name << " " << grey;
            // AgX's published inset matrix is off white by 1.4e-4, Hill's by 3e-5.
            EXPECT_NEAR(c.x, c.y, 5e-4) << name << " " << grey;
            EXPECT_NEAR(c.z, c.y, 5e-4) << name << " " << grey;
            last = c.y;
        }
        EXPECT_LT(curve(vec3(0.0)).y, 1e-6) << name;
        EXPECT_GT(last, 0.98) << name;
    }
}

TEST(Tone, ColoursStayInRange)
{
    Uniform uniform(1);
    for (int i = 0; i < 10000; i++) {
        const vec3 c(uniform.between_log(1e-6, 1e5), uniform.between_log(1e-6, 1e5),
                     uniform.between_log(1e-6, 1e5));
        for (const auto& [name, curve] : curves)
            for (double channel : components(curve(c)))
                EXPECT_TRUE(channel >= 0.0 && channel <= 1.0 + 1e-12) << name << " " << channel;
    }
}

TEST(Tone, ReinhardFixedPoints)
{
    EXPECT_EQ(tone_reinhard(vec3(0.0, 1.0, 3.0)).x, 0.0);
    EXPECT_EQ(tone_reinhard(vec3(0.0, 1.0, 3.0)).y, 0.5);
    EXPECT_EQ(tone_reinhard(vec3(0.0, 1.0, 3.0)).z, 0.75);
}

TEST(Tone, LinearIsCutAtOne)
{
    const vec3 c = tone_linear(vec3(0.25, 1.0, 7.0));
    EXPECT_EQ(distance(c, vec3(0.25, 1.0, 1.0)), 0.0);
}

// PBR Neutral undone: the inverse that the specification gives, from display back to light.
vec3 inverse_neutral(vec3 out)
{
    const double F90 = 0.04, Ks = 0.8 - F90, Kd = 0.15;
    std::array<double, 3> c = components(out);
    const double peak = std::max({c[0], c[1], c[2]});
    if (peak > Ks) {
        const double before = (1.0 - Ks) * (1.0 - Ks) / (1.0 - peak) - (1.0 - 2.0 * Ks);
        const double towards_white = 1.0 - 1.0 / (Kd * (before - peak) + 1.0);
        for (double& channel : c)
            channel = (channel - towards_white * peak) / (1.0 - towards_white) * before / peak;
    }
    const double least = std::min({c[0], c[1], c[2]});
    const double offset = least < F90 ? std::sqrt(least / 6.25) - least : F90;
    return {c[0] + offset, c[1] + offset, c[2] + offset};
}

TEST(Tone, NeutralKeepsBaseColours)
{
    // c - F90 for channels from 0.08 to 0.8: the guarantee of the specification.
    for (double a : {0.08, 0.2, 0.5, 0.8})
        for (double b : {0.08, 0.3, 0.8})
            EXPECT_LT(distance(tone_neutral(vec3(a, b, 0.4)), vec3(a - 0.04, b - 0.04, 0.36)), 1e-15);
}

TEST(Tone, NeutralIsTheSpecificationsInverseUndone)
{
    Uniform uniform(2);
    for (int i = 0; i < 10000; i++) {
        const vec3 c(uniform.between_log(1e-3, 30.0), uniform.between_log(1e-3, 30.0),
                     uniform.between_log(1e-3, 30.0));
        EXPECT_LT(distance(inverse_neutral(tone_neutral(c)), c), 1e-9 * (1.0 + distance(c, vec3(0.0))));
    }
}

TEST(Tone, NeutralGreys)
{
    // Below 0.08 a parabola, 6.25 x^2; beyond 0.8 a hyperbola, 1 - 0.24^2 / (x - 0.04 - 0.52).
    EXPECT_NEAR(tone_neutral(vec3(0.04)).x, 0.01, 1e-15);
    EXPECT_NEAR(tone_neutral(vec3(0.8)).x, 0.76, 1e-15);
    EXPECT_NEAR(tone_neutral(vec3(1.0)).x, 1.0 - 0.0576 / 0.44, 1e-15);
    EXPECT_NEAR(tone_neutral(vec3(10.0)).x, 1.0 - 0.0576 / 9.44, 1e-15);
}

TEST(Tone, NeutralIsSmoothWhereItsPiecesMeet)
{
    // "All partial derivatives are continuous": slopes to either side of both joints.
    for (double joint : {0.08, 0.8}) {
        const double h = 1e-6;
        const auto grey = [](double x) { return tone_neutral(vec3(x)).x; };
        EXPECT_NEAR((grey(joint) - grey(joint - h)) / h, (grey(joint + h) - grey(joint)) / h, 1e-4) << joint;
    }
}

// AgX's curve in Sobotka's own form: scale * hyperbola(slope (x - pivot) / scale) + 0.5, where the hyperbola
// is u / (1 + u^p)^(1/p) and the scale is what takes it through the corner.
double sobotka_sigmoid(double x)
{
    const double pivot = 10.0 / 16.5, slope = 2.0;
    const double power = x < pivot ? 3.0 : 3.25;
    const double run = x < pivot ? pivot : 1.0 - pivot, rise = 0.5;
    const double scale =
        std::pow(std::pow(slope * run, -power) * (std::pow(slope * run / rise, power) - 1.0), -1.0 / power);
    const double u = slope * std::abs(x - pivot) / scale;
    const double height = scale * u / std::pow(1.0 + std::pow(u, power), 1.0 / power);
    return x < pivot ? 0.5 - height : 0.5 + height;
}

TEST(Tone, AgxSigmoidIsSobotkas)
{
    for (int i = 0; i <= 1000; i++)
        EXPECT_NEAR(agx_sigmoid(i / 1000.0), sobotka_sigmoid(i / 1000.0), 1e-7) << i;
}

TEST(Tone, AgxSigmoidMeetsItsConditions)
{
    const double pivot = 10.0 / 16.5, h = 1e-6;
    EXPECT_NEAR(agx_sigmoid(0.0), 0.0, 1e-7);
    EXPECT_NEAR(agx_sigmoid(pivot), 0.5, 1e-15);
    EXPECT_NEAR(agx_sigmoid(1.0), 1.0, 1e-7);
    EXPECT_NEAR((agx_sigmoid(pivot + h) - agx_sigmoid(pivot - h)) / (2.0 * h), 2.0, 1e-6);
}

using Rows = std::array<std::array<double, 3>, 3>;

// Solution of rows * x = b by Cramer's rule.
vec3 solve(const Rows& m, vec3 b)
{
    const auto det = [](const Rows& r) {
        return r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1]) -
               r[0][1] * (r[1][0] * r[2][2] - r[1][2] * r[2][0]) +
               r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
    };
    const std::array<double, 3> right = components(b);
    std::array<double, 3> x = {};
    for (size_t column = 0; column < 3; column++) {
        Rows replaced = m;
        for (size_t row = 0; row < 3; row++)
            replaced[row][column] = right[row];
        x[column] = det(replaced) / det(m);
    }
    return {x[0], x[1], x[2]};
}

vec3 times(const Rows& m, vec3 v)
{
    const auto row = [&](size_t i) { return m[i][0] * v.x + m[i][1] * v.y + m[i][2] * v.z; };
    return {row(0), row(1), row(2)};
}

// The inset matrix by rows, as AgX's OCIO configuration has it; its outset is the inverse, solved for here.
constexpr Rows agx_inset = {{{0.842479062253094, 0.0784335999999992, 0.0792237451477643},
                             {0.0423282422610123, 0.878468636469772, 0.0791661274605434},
                             {0.0423756549057051, 0.0784336, 0.879142973793104}}};

TEST(Tone, AgxFromItsDefinition)
{
    Uniform uniform(3);
    for (int i = 0; i < 2000; i++) {
        const vec3 c(uniform.between_log(1e-5, 100.0), uniform.between_log(1e-5, 100.0),
                     uniform.between_log(1e-5, 100.0));
        // 10 stops below middle grey is code 0, 6.5 above it code 1.
        const auto code = [](double x) {
            return sobotka_sigmoid(std::clamp((std::log2(x / 0.18) + 10.0) / 16.5, 0.0, 1.0));
        };
        const vec3 v = times(agx_inset, c);
        const vec3 out = solve(agx_inset, vec3(code(v.x), code(v.y), code(v.z)));
        const auto display = [](double x) { return std::pow(std::clamp(x, 0.0, 1.0), 2.2); };
        EXPECT_LT(distance(tone_agx(c), vec3(display(out.x), display(out.y), display(out.z))), 2e-6);
    }
}

TEST(Tone, AgxMiddleGreyIsHalfTheCode)
{
    EXPECT_NEAR(std::pow(tone_agx(vec3(0.18)).y, 1.0 / 2.2), 0.5, 2e-4);
}

TEST(Tone, AgxBrightSaturatedLightTurnsWhite)
{
    const vec3 red = tone_agx(vec3(1000.0, 1.0, 1.0));
    EXPECT_GT(red.y, 0.7);
}

} // namespace
} // namespace lambent::test
