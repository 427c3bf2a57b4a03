// Evenly distributed random numbers (Owen-scrambled Sobol points), and independent ones for decisions.
#pragma once

#include "base/hash.h"

#include <array>
#include <cstdint>

namespace lambent::reference {

/// Point `index` in the first four Sobol dimensions, each from 0 to 2^32 - 1. Any 2^k consecutive points that start
/// at a multiple of 2^k are evenly distributed in every dimension, and in the first two together. [Sobol 1967;
/// direction numbers: Joe and Kuo 2008]
std::array<std::uint32_t, 4> sobol(std::uint32_t index);

/// Nested uniform scrambling of a 32-bit fraction. [Owen 1995; as a hash: Laine and Karras 2011, "Stratified sampling
/// for stochastic transparency"; its use: Burley 2020, "Practical hash-based Owen scrambling", JCGT 9(4)]
std::uint32_t owen_scrambled(std::uint32_t fraction, std::uint32_t seed);

/// Random numbers of one sample of a pixel. Each call of next4() uses another four dimensions. Samples of one
/// `sequence` are evenly distributed over `index` = 0, 1, 2 ...; samples of different sequences are independent.
class SampleSequence {
public:
    SampleSequence(std::uint32_t sequence, std::uint32_t index) : sequence_(sequence), index_(index) {}

    /// Four numbers in [0, 1), evenly distributed over the indices of the sequence.
    std::array<double, 4> next4();

    /// A number in [0, 1), independent of all others.
    double random();

private:
    std::uint32_t sequence_, index_;
    std::uint32_t dimension_ = 0, drawn_ = 0;
};

} // namespace lambent::reference
