// The equations in double, for tests, tables and values that are computed once. See README.md.
#pragma once

#include <algorithm>
#include <cmath>

// The functions are not inline, and no file uses all of them: each file gets its own copies, without a warning.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"

#undef ONE_BODY
#define ONE_BODY

namespace lambent::in_double {
namespace {

using Real = double;
using Mask = bool;
using std::abs, std::acos, std::cos, std::exp2, std::floor, std::log2, std::max, std::min, std::sin,
    std::sqrt;

inline Real atan(Real y, Real x)
{
    return std::atan2(y, x);
}
inline Real inversesqrt(Real a)
{
    return 1.0 / sqrt(a);
}
// A number as mantissa * 4^exponent, mantissa in [1, 4).
struct PowersOfFour {
    Real mantissa, exponent;
};

inline PowersOfFour powers_of_four(Real a)
{
    const Real exponent = floor(0.5 * log2(a));
    return {a * exp2(-2.0 * exponent), exponent};
}

inline bool any_of(Mask m)
{
    return m;
}

inline Real select(Mask m, Real yes, Real no)
{
    return m ? yes : no;
}

#include "equations/vectors.h"

#include "equations/all.glsl"

} // namespace
} // namespace lambent::in_double

#pragma GCC diagnostic pop
