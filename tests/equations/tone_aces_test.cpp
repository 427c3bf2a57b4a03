// Hill's fit against what it fits: the Academy's colour spaces and tone scales, from their published
// definitions.
#include "tests/equations/directions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lambent::test {
namespace {

using in_double::tone_aces;

using Matrix = std::array<std::array<double, 3>, 3>;
using Vector = std::array<double, 3>;

Matrix product(const Matrix& a, const Matrix& b)
{
    Matrix c = {};
    for (size_t i = 0; i < 3; i++)
        for (size_t j = 0; j < 3; j++)
            for (size_t k = 0; k < 3; k++)
                c[i][j] += a[i][k] * b[k][j];
    return c;
}

Vector product(const Matrix& a, const Vector& v)
{
    Vector c = {};
    for (size_t i = 0; i < 3; i++)
        for (size_t k = 0; k < 3; k++)
            c[i] += a[i][k] * v[k];
    return c;
}

Matrix inverse(const Matrix& m)
{
    Matrix r = {};
    for (size_t i = 0; i < 3; i++)
        for (size_t j = 0; j < 3; j++) {
            const size_t a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
            r[i][j] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
        }
    const double det = m[0][0] * r[0][0] + m[0][1] * r[1][0] + m[0][2] * r[2][0];
    for (auto& row : r)
        for (double& e : row)
            e /= det;
    return r;
}

Matrix diagonal(const Vector& v)
{
    return {{{v[0], 0, 0}, {0, v[1], 0}, {0, 0, v[2]}}};
}

struct Chromaticity {
    double x, y;
};

Vector xyz(Chromaticity c)
{
    return {c.x / c.y, 1.0, (1.0 - c.x - c.y) / c.y};
}

struct Space {
    Chromaticity red, green, blue, white;
};

constexpr Space rec709 = {{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}}; // ITU-R BT.709
constexpr Space ap1 = {
    {0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, {0.32168, 0.33767}}; // S-2014-004 (ACEScg)

Matrix to_xyz(const Space& s)
{
    const Vector r = xyz(s.red), g = xyz(s.green), b = xyz(s.blue);
    const Matrix primaries = {{{r[0], g[0], b[0]}, {r[1], g[1], b[1]}, {r[2], g[2], b[2]}}};
    return product(primaries, diagonal(product(inverse(primaries), xyz(s.white))));
}

// Bradford's chromatic adaptation from the white of one space to that of another.
Matrix adaptation(const Space& from, const Space& to)
{
    const Matrix bradford = {
        {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
    const Vector a = product(bradford, xyz(from.white)), b = product(bradford, xyz(to.white));
    const Matrix gains = diagonal({b[0] / a[0], b[1] / a[1], b[2] / a[2]});
    return product(inverse(bradford), product(gains, bradford));
}

// AP1 colours drawn towards their luminance; 1 leaves them.
Matrix saturation(double amount)
{
    const Vector luminance = to_xyz(ap1)[1];
    Matrix m = diagonal({amount, amount, amount});
    for (auto& row : m)
        for (size_t j = 0; j < 3; j++)
            row[j] += (1.0 - amount) * luminance[j];
    return m;
}

// A quadratic B-spline through log10 light: the Academy's segmented spline, between its end points.
struct Spline {
    std::vector<double> low, high;
    double begin, middle, end;
};

double evaluate(const Spline& s, double x)
{
    const double at = std::log10(x), middle = std::log10(s.middle);
    const std::vector<double>& c = at < middle ? s.low : s.high;
    const double from = at < middle ? std::log10(s.begin) : middle,
                 to = at < middle ? middle : std::log10(s.end);
    const double knots = static_cast<double>(c.size() - 3);
    const double place = std::clamp((at - from) / (to - from), 0.0, 1.0 - 1e-12) * knots;
    const size_t i = static_cast<size_t>(place);
    const double t = place - std::floor(place);
    const double log_y =
        0.5 * c[i] * (1.0 - t) * (1.0 - t) + c[i + 1] * (0.5 + t - t * t) + 0.5 * c[i + 2] * t * t;
    return std::pow(10.0, log_y);
}

// Reference rendering and 48-nit output tone scales of ACES 1.0 (ctl: ACESlib.Tonescales), from 6.5 stops
// below middle grey to 6.5 above: display-linear light in [0, 1].
double academy_tone(double x)
{
    const Spline rendering = {{-4.0, -4.0, -3.1573765773, -0.4852499958, 1.8477324706, 1.8477324706},
                              {-0.7185482425, 2.0810307172, 3.6681241237, 4.0, 4.0, 4.0},
                              0.18 * std::exp2(-15.0),
                              0.18,
                              0.18 * std::exp2(18.0)};
    const Spline output = {{-1.6989700043, -1.6989700043, -1.4779, -1.2291, -0.8648, -0.448, 0.00518,
                            0.4511080334, 0.9113744414, 0.9113744414},
                           {0.5154386965, 0.8470437783, 1.1358, 1.3802, 1.5197, 1.5985, 1.6467, 1.6746091357,
                            1.6878733390, 1.6878733390},
                           evaluate(rendering, 0.18 * std::exp2(-6.5)),
                           evaluate(rendering, 0.18),
                           evaluate(rendering, 0.18 * std::exp2(6.5))};
    return (evaluate(output, evaluate(rendering, x)) - 0.02) / (48.0 - 0.02);
}

// Light in [0, 1] for the display, from the Academy's matrices (saturation 0.96 in, 0.93 out) around a tone
// scale.
template <class Tone>
Vector academy(const Vector& light, const Tone& tone)
{
    const Matrix in = product(product(saturation(0.96), inverse(to_xyz(ap1))),
                              product(adaptation(rec709, ap1), to_xyz(rec709)));
    const Matrix out = product(product(inverse(to_xyz(rec709)), adaptation(ap1, rec709)),
                               product(to_xyz(ap1), saturation(0.93)));
    Vector v = product(in, light);
    for (double& channel : v)
        channel = tone(channel / 0.6);
    Vector display = product(out, v);
    for (double& channel : display)
        channel = std::clamp(channel, 0.0, 1.0);
    return display;
}

double worst_difference(const Vector& a, vec3 b)
{
    return std::max({std::abs(a[0] - b.x), std::abs(a[1] - b.y), std::abs(a[2] - b.z)});
}

TEST(ToneAces, SplineKnowsMiddleGrey)
{
    // The published points of the two scales: 0.18 becomes 4.8 cd/m^2.
    EXPECT_NEAR(academy_tone(0.18) * (48.0 - 0.02) + 0.02, 4.8, 0.01);
}

TEST(ToneAces, WithinTheFitOfTheAcademysToneScales)
{
    // Hill's rational function is up to 0.013 away from the splines for greys, and 0.022 for colours, which
    // mix three such errors.
    Uniform uniform(1);
    for (int i = 0; i < 3000; i++) {
        const auto draw = [&] { return uniform.between_log(0.003, 6.0); };
        const Vector c = {draw(), draw(), draw()};
        EXPECT_LT(worst_difference(academy(c, academy_tone), tone_aces(vec3(c[0], c[1], c[2]))), 0.023);
    }
    for (int i = 0; i <= 200; i++) {
        const double grey = 0.003 * std::pow(2000.0, i / 200.0);
        EXPECT_LT(worst_difference(academy({grey, grey, grey}, academy_tone), tone_aces(vec3(grey))), 0.014)
            << grey;
    }
}

// The published matrices have five decimals; around Hill's function the derived ones give the same to 2e-4.
TEST(ToneAces, MatricesFromPrimariesAndWhites)
{
    const auto hill = [](double v) {
        // (v^2 + 0.0245786 v - 0.000090537) / (0.983729 v^2 + 0.4329510 v + 0.238081), by synthetic division.
        const double p = 1.0 / 0.983729;
        const double rest = (0.0245786 - 0.4329510 * p) * v - (0.000090537 + 0.238081 * p);
        return p + rest / ((0.983729 * v + 0.4329510) * v + 0.238081);
    };
    Uniform uniform(2);
    for (int i = 0; i < 3000; i++) {
        const auto draw = [&] { return uniform.between_log(1e-3, 1e4); };
        const Vector c = {draw(), draw(), draw()};
        EXPECT_LT(worst_difference(academy(c, hill), tone_aces(vec3(c[0], c[1], c[2]))), 2e-4);
    }
}

TEST(ToneAces, MiddleGreyStaysAboutWhereItWas)
{
    EXPECT_NEAR(tone_aces(vec3(0.18)).y, 0.18, 0.04);
}

TEST(ToneAces, HugeLightIsWhiteAndFinite)
{
    for (double light : {1e6, 1e20, 1e38})
        EXPECT_LT(distance(tone_aces(vec3(light)), vec3(1.0)), 1e-9);
}

} // namespace
} // namespace lambent::test
