// Two things timed in one run: these machines are noisy, so only the ratio of neighbours in time is told.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

namespace lambent::bench {

/// Wall-clock seconds of one call.
template <class Work>
double seconds(Work&& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

inline double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

struct Comparison {
    double ours;  ///< median seconds
    double other; ///< median seconds
    double ratio; ///< median of ours / other, pair by pair
};

/// Runs `ours` and `other` in turn, `rounds` times after one warm-up of each, and prints one line.
template <class Ours, class Other>
Comparison side_by_side(const std::string& label, int rounds, Ours&& ours, Other&& other)
{
    ours();
    other();
    std::vector<double> a, b, ratios;
    for (int round = 0; round < rounds; ++round) {
        a.push_back(seconds(ours));
        b.push_back(seconds(other));
        ratios.push_back(a.back() / b.back());
    }
    const Comparison result{median(a), median(b), median(ratios)};
    std::printf("%-52s %9.2f ms  against %9.2f ms  ratio %.3f\n", label.c_str(), result.ours * 1e3,
                result.other * 1e3, result.ratio);
    std::fflush(stdout);
    return result;
}

} // namespace lambent::bench
