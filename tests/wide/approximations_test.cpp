// The error of every approximation over its range, for every Highway target of this processor: the bounds are
// those that src/wide/approximations.h states.
#include "tests/wide/evaluate.h"
#include "tests/support/each_target.h"

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace lambent::test {
namespace {

class Approximations : public EachTarget {};

constexpr int points = 1 << 18;

// Every float within 1000 of x.
void add_neighbours(std::vector<float>& to, float x)
{
    const uint32_t middle = std::bit_cast<uint32_t>(x);
    for (uint32_t b = middle - 1000; b != middle + 1001; b++)
        to.push_back(std::bit_cast<float>(b));
}

// Positive floats, equally many in each octave from low to high, and every float near the ends of an octave
// and near its point sqrt 2, where approximations change pieces.
std::vector<float> all_octaves(float low, float high)
{
    std::vector<float> numbers = {low, high};
    const uint32_t first = std::bit_cast<uint32_t>(low), last = std::bit_cast<uint32_t>(high);
    for (uint64_t i = 0; i < points; i++)
        numbers.push_back(std::bit_cast<float>(first + static_cast<uint32_t>((last - first) * i / points)));
    for (float x : {0.5f, 0.70710678f, 1.0f, 1.41421356f, 2.0f, 4096.0f})
        if (x > low && x < high)
            add_neighbours(numbers, x);
    return numbers;
}

// Equally spaced from low to high.
std::vector<float> even(double low, double high)
{
    std::vector<float> numbers;
    for (int i = 0; i <= points; i++)
        numbers.push_back(static_cast<float>(low + (high - low) * i / points));
    return numbers;
}

struct Error {
    double worst = 0.0;
    float at = 0.0f;
};

// Largest error of the results against `exact` in double; relative to the exact value, or absolute.
template <class Exact>
Error measure(const std::vector<float>& results, const std::vector<float>& at, const Exact& exact,
              bool relative)
{
    Error error;
    for (size_t i = 0; i < at.size(); i++) {
        const double wanted = exact(i);
        const double difference = std::abs(results[i] - wanted);
        const double e = relative && wanted != 0.0 ? difference / std::abs(wanted) : difference;
        if (!(e <= error.worst))
            error = {std::isfinite(e) ? e : HUGE_VAL, at[i]};
    }
    return error;
}

void expect_below(double bound, const Error& error, const char* what)
{
    std::printf("%-8s %-36s %.2e of %.1e allowed, at %.9g\n", hwy::TargetName(hwy::SupportedTargets()), what,
                error.worst, bound, static_cast<double>(error.at));
    EXPECT_LE(error.worst, bound) << what;
}

struct OneNumber {
    Function function;
    double (*exact)(double);
};

Error relative_error(OneNumber f, const std::vector<float>& at)
{
    return measure(
        evaluate(f.function, at), at, [&](size_t i) { return f.exact(at[i]); }, true);
}

Error absolute_error(OneNumber f, const std::vector<float>& at)
{
    return measure(
        evaluate(f.function, at), at, [&](size_t i) { return f.exact(at[i]); }, false);
}

const OneNumber reciprocal = {Function::reciprocal, [](double a) { return 1.0 / a; }};
const OneNumber inversesqrt = {Function::inversesqrt, [](double a) { return 1.0 / std::sqrt(a); }};
const OneNumber logarithm = {Function::log2, [](double a) { return std::log2(a); }};
const OneNumber power = {Function::exp2, [](double a) { return std::exp2(a); }};
const OneNumber arc_cosine = {Function::acos, [](double a) { return std::acos(a); }};
const OneNumber sine = {Function::sin, [](double a) { return std::sin(a); }};
const OneNumber cosine = {Function::cos, [](double a) { return std::cos(a); }};

TEST_P(Approximations, Reciprocal)
{
    const double bound = 3e-7; // (1.5 2^-12)^2 for the step from x86's estimate, and two roundings
    std::vector<float> at = all_octaves(0x1p-125f, 0x1p125f);
    expect_below(bound, relative_error(reciprocal, at), "1 / a");
    for (float& a : at)
        a = -a;
    expect_below(bound, relative_error(reciprocal, at), "1 / a, a < 0");
}

TEST_P(Approximations, Quotient)
{
    const std::vector<float> b = all_octaves(0x1p-60f, 0x1p60f);
    std::vector<float> a = b;
    std::reverse(a.begin(), a.end());
    const std::vector<float> results = evaluate(Function::quotient, a, b);
    const auto exact = [&](size_t i) { return static_cast<double>(a[i]) / static_cast<double>(b[i]); };
    expect_below(4e-7, measure(results, b, exact, true), "a / b");
}

TEST_P(Approximations, InverseSquareRoot)
{
    expect_below(4e-7, relative_error(inversesqrt, all_octaves(0x1p-125f, 0x1p126f)), "1 / sqrt(a)");
}

TEST_P(Approximations, PowersOfFourAreExact)
{
    const std::vector<float> at = all_octaves(0x1p-126f, 0x1.fffffep127f);
    const std::vector<float> mantissas = evaluate(Function::mantissa, at);
    const std::vector<float> exponents = evaluate(Function::exponent, at);
    for (size_t i = 0; i < at.size(); i++) {
        const int octave = std::ilogb(at[i]), half = static_cast<int>(std::floor(octave / 2.0));
        ASSERT_EQ(exponents[i], static_cast<float>(half)) << at[i];
        ASSERT_EQ(mantissas[i], std::ldexp(at[i], -2 * half)) << at[i];
    }
}

TEST_P(Approximations, Logarithm)
{
    expect_below(4e-7, relative_error(logarithm, all_octaves(0x1p-126f, 0x1.fffffep127f)), "log2(a)");
    expect_below(4e-7, relative_error(logarithm, even(0.7072, 1.4142)), "log2(a) about 1");
    std::vector<float> one;
    add_neighbours(one, 1.0f);
    expect_below(2e-7, relative_error(logarithm, one), "log2(a) beside 1");
}

TEST_P(Approximations, Power)
{
    expect_below(3e-7, relative_error(power, even(-126.0, 127.0)), "exp2(a)");
    expect_below(3e-7, relative_error(power, even(-1.0, 1.0)), "exp2(a) about 0");
    const std::vector<float> results = evaluate(Function::exp2, {-126.5f, -1e30f, 127.5f, 1e30f});
    EXPECT_NEAR(results[0] / 0x1p-126f, 1.0, 2e-7);
    EXPECT_NEAR(results[1] / 0x1p-126f, 1.0, 2e-7);
    EXPECT_NEAR(results[2] / 0x1p127f, 1.0, 2e-7);
    EXPECT_NEAR(results[3] / 0x1p127f, 1.0, 2e-7);
}

TEST_P(Approximations, ArcTangent)
{
    // A circle, with points on and beside the axes and diagonals, at three scales.
    std::vector<float> y, x;
    for (double radius : {1e-15, 1.0, 1e15})
        for (int i = 0; i <= points; i += 2) {
            const double turn = 6.283185307179586 * i / points;
            y.push_back(static_cast<float>(radius * std::sin(turn)));
            x.push_back(static_cast<float>(radius * std::cos(turn)));
        }
    for (float a : {0.0f, -0.0f, 1e-20f, -1e-20f, 1.0f, -1.0f})
        for (float b : {1.0f, -1.0f}) {
            y.insert(y.end(), {a, b});
            x.insert(x.end(), {b, a});
        }
    const std::vector<float> results = evaluate(Function::atan, y, x);
    const auto exact = [&](size_t i) {
        return std::atan2(static_cast<double>(y[i]), static_cast<double>(x[i]));
    };
    expect_below(1e-6, measure(results, y, exact, false), "atan(y, x)");
}

TEST_P(Approximations, ArcCosine)
{
    std::vector<float> at = even(-1.0, 1.0);
    for (float a : {0x1.fffffep-1f, 0x1.fffffcp-1f, 1e-10f})
        at.insert(at.end(), {a, -a});
    expect_below(2e-6, absolute_error(arc_cosine, at), "acos(a)");
    EXPECT_EQ(evaluate(Function::acos, {1.0f})[0], 0.0f);
}

TEST_P(Approximations, SineAndCosine)
{
    expect_below(2e-7, absolute_error(sine, even(-3.15, 3.15)), "sin(a), half a turn");
    expect_below(2e-7, absolute_error(cosine, even(-3.15, 3.15)), "cos(a), half a turn");
    expect_below(2e-7, absolute_error(sine, even(-39000.0, 39000.0)), "sin(a), to 39000");
    expect_below(2e-7, absolute_error(cosine, even(-39000.0, 39000.0)), "cos(a), to 39000");
}

INSTANTIATE_TEST_SUITE_P(Targets, Approximations, testing::ValuesIn(hwy::SupportedAndGeneratedTargets()),
                         [](const auto& info) { return std::string(hwy::TargetName(info.param)); });

} // namespace
} // namespace lambent::test
