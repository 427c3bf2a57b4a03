// Means of independent pictures, and how sure they are.
#pragma once

#include "bench/cycles/programs.h"

#include <cstddef>
#include <span>
#include <vector>

namespace lambent::bench {

/// A mean and the variance of that mean.
struct Measured {
    double mean = 0.0;
    double variance = 0.0;
};

/// Of two or more equally good, independent values.
Measured measured(const std::vector<double>& values);

/// (a - b) / its standard deviation; 0 where neither varies and both are equal.
double standardised(const Measured& a, const Measured& b);

/// Mean of a pixel's channels in each picture.
std::vector<double> values_at(std::span<const Taken> pictures, std::size_t pixel);

/// The same, averaged over pixels.
std::vector<double> values_over(std::span<const Taken> pictures, const std::vector<std::size_t>& pixels);

} // namespace lambent::bench
