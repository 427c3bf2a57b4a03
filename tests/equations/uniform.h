// Seeded uniform numbers that are the same with every standard library.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace lambent::test {

class Uniform {
public:
    explicit Uniform(uint64_t seed) : engine_(seed) {}

    // In (0, 1).
    double operator()() { return (static_cast<double>(engine_() >> 12) + 0.5) * 0x1p-52; }
    double between(double low, double high) { return low + (high - low) * (*this)(); }
    // Uniform in the logarithm.
    double between_log(double low, double high) { return low * std::pow(high / low, (*this)()); }

private:
    std::mt19937_64 engine_;
};

} // namespace lambent::test
