#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/wide/evaluate.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"
#include "tests/wide/evaluate.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace lambent::test::HWY_NAMESPACE {
namespace {

#include "wide/wide.h"

Real apply(Function function, Real a, Real b)
{
    switch (function) {
    case Function::reciprocal:
        return reciprocal(a);
    case Function::inversesqrt:
        return inversesqrt(a);
    case Function::mantissa:
        return powers_of_four(a).mantissa;
    case Function::exponent:
        return powers_of_four(a).exponent;
    case Function::log2:
        return log2(a);
    case Function::exp2:
        return exp2(a);
    case Function::acos:
        return acos(a);
    case Function::sin:
        return sin(a);
    case Function::cos:
        return cos(a);
    case Function::quotient:
        return a / b;
    case Function::atan:
        return atan(a, b);
    }
    return Real(0.0);
}

// n is a multiple of max_lanes.
void evaluate_lanes(Function function, size_t n, const float* a, const float* b, float* to)
{
    for (size_t i = 0; i < n; i += lane_count)
        store(apply(function, load(a + i), load(b + i)), to + i);
}

} // namespace
} // namespace lambent::test::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::test {

HWY_EXPORT(evaluate_lanes);

std::vector<float> evaluate(Function function, const std::vector<float>& a, const std::vector<float>& b)
{
    constexpr size_t most_lanes = 16;
    const size_t padded = (a.size() + most_lanes - 1) / most_lanes * most_lanes;
    std::vector<float> first = a, second = b, results(padded);
    first.resize(padded, 1.0f);
    second.resize(padded, 1.0f);
    HWY_DYNAMIC_DISPATCH(evaluate_lanes)(function, padded, first.data(), second.data(), results.data());
    results.resize(a.size());
    return results;
}

} // namespace lambent::test
#endif
