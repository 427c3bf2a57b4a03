// The approximations of src/wide over batches, with the Highway target that is chosen now.
#pragma once

#include <vector>

namespace lambent::test {

enum class Function {
    reciprocal,
    inversesqrt,
    mantissa, // of powers_of_four
    exponent,
    log2,
    exp2,
    acos,
    sin,
    cos,
    quotient, // of the first by the second
    atan      // the angle of (second, first)
};

// One result for each number of `a`; `b` is as long, or empty for functions of one number.
std::vector<float> evaluate(Function function, const std::vector<float>& a, const std::vector<float>& b = {});

} // namespace lambent::test
