#include "bench/vulkan/shading_flops.h"

#include <cmath>
#include <cstdint>

namespace lambent::bench {
namespace {

std::int64_t counted = 0;

// A number that counts what is done with it.
struct Real {
    double value;

    constexpr Real(double v) : value(v) {} // literals of the text
    constexpr explicit Real(int v) : value(v) {}
};

Real done(double value)
{
    ++counted;
    return {value};
}

// Not all of the text is used, nor all that it may use.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"

// clang-format off
Real operator+(Real a, Real b) { return done(a.value + b.value); }
Real operator-(Real a, Real b) { return done(a.value - b.value); }
Real operator-(Real a) { return {-a.value}; } // a sign costs nothing
Real operator*(Real a, Real b) { return done(a.value * b.value); }
Real operator/(Real a, Real b) { return done(a.value / b.value); }
Real& operator+=(Real& a, Real b) { return a = a + b; }
Real& operator-=(Real& a, Real b) { return a = a - b; }
Real& operator*=(Real& a, Real b) { return a = a * b; }
using Mask = bool;
Mask operator<(Real a, Real b) { ++counted; return a.value < b.value; }
Mask operator>(Real a, Real b) { return b < a; }
Mask operator<=(Real a, Real b) { ++counted; return a.value <= b.value; }
Mask operator>=(Real a, Real b) { return b <= a; }
Mask operator==(Real a, Real b) { ++counted; return a.value == b.value; }
Real abs(Real a) { return {std::fabs(a.value)}; }
Real min(Real a, Real b) { return done(std::fmin(a.value, b.value)); }
Real max(Real a, Real b) { return done(std::fmax(a.value, b.value)); }
Real floor(Real a) { return done(std::floor(a.value)); }
Real sqrt(Real a) { return done(std::sqrt(a.value)); }
Real inversesqrt(Real a) { return done(1.0 / std::sqrt(a.value)); }
Real exp2(Real a) { return done(std::exp2(a.value)); }
Real log2(Real a) { return done(std::log2(a.value)); }
Real sin(Real a) { return done(std::sin(a.value)); }
Real cos(Real a) { return done(std::cos(a.value)); }
Real acos(Real a) { return done(std::acos(a.value)); }
Real atan(Real y, Real x) { return done(std::atan2(y.value, x.value)); }
Real select(Mask m, Real yes, Real no) { return done((m ? yes : no).value); }
// clang-format on

struct PowersOfFour {
    Real mantissa, exponent;
};

// As on a device: the exponent's bits.
PowersOfFour powers_of_four(Real a)
{
    const double exponent = std::floor(0.5 * std::log2(a.value));
    counted += 4;
    return {a.value * std::exp2(-2.0 * exponent), exponent};
}

#include "equations/vectors.h"

#include "equations/all.glsl"

// Even light, sampled by a spiral of a few points.
struct Environment {
    int samples, lamps;
};
struct LightSum {
    vec3 first, second;
};

LightSum no_light(const Environment&)
{
    return {vec3(0.0), vec3(0.0)};
}
LightSum with_light(const Environment&, LightSum sum, vec3, Real, vec2 weights)
{
    const vec3 light(1.0);
    return {sum.first + weights.x * light, sum.second + weights.y * light};
}
vec3 first_light(const Environment&, LightSum sum)
{
    return sum.first;
}
vec3 second_light(const Environment&, LightSum sum)
{
    return sum.second;
}
Real level_one_variance(const Environment&)
{
    return 1e-4;
}
vec2 lamp_variances(const Environment&)
{
    return {1e-3, 4e-3};
}
int lamp_count(const Environment& e)
{
    return e.lamps;
}
vec3 lamp_direction(const Environment&, int)
{
    return {0.0, 1.0, 0.0};
}
vec3 lamp_light(const Environment&, int)
{
    return vec3(1.0);
}
int sample_count(const Environment& e)
{
    return e.samples;
}
vec3 cap_point(const Environment& e, int i)
{
    return {(i + 0.5) / e.samples, std::cos(2.4 * i), std::sin(2.4 * i)};
}
vec2 pixel_point(const Environment&, int)
{
    return {0.1, -0.2};
}

bool any_of(Mask m)
{
    return m;
}
int has_stretch()
{
    return 0;
}

#include "shading/surface/pixel.glsl"
#include "shading/lobes/facets.glsl"
#include "shading/lobes/ggx_light.glsl"

#pragma GCC diagnostic pop

double flops_of(const Environment& environment)
{
    const Mirror mirror = {{{0.0, 0.0, 1.0}, {0.6, 0.0, 0.8}, {1e-3, 0.0, 1e-4}, {0.0, 1e-3, 1e-4}},
                           {0.0, 1.0, 0.0},
                           vec2(0.25),
                           vec3(0.0),
                           {0.8, 0.1}};
    counted = 0;
    specular_ggx(environment, mirror);
    return static_cast<double>(counted);
}

} // namespace

SpecularFlops count_specular_flops()
{
    SpecularFlops flops;
    const double base = flops_of({1, 0});
    flops.sample = flops_of({2, 0}) - base;
    flops.lamp = flops_of({1, 1}) - base;
    flops.fragment = base - flops.sample;
    return flops;
}

} // namespace lambent::bench
