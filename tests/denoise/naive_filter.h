// The filter in double, pixel by pixel over whole pictures, written from docs/FILTER.md without the library's code.
#pragma once

#include "denoise/light_filter.h"

#include <array>
#include <vector>

namespace lambent::denoise::test {

constexpr int naive_levels = 5;

/// Two estimates of each level: control variate (even), ratio (odd).
constexpr int naive_candidates = 2 * naive_levels;

using DoublePlane = std::vector<double>;
using DoubleRgb = std::array<DoublePlane, 3>;

struct NaiveResult {
    std::array<std::array<DoubleRgb, 2>, naive_candidates> candidates; ///< light by candidate and half
    std::vector<int> choices;
    DoubleRgb light, gap;
};

NaiveResult naive_filter(const Picture& picture, const Light& light, bool lobe, const Settings& settings);

} // namespace lambent::denoise::test
