// Sums over the rows of a panorama, in parallel.
#pragma once

#include "environment/bake/texel_sums.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <vector>

namespace lambent::environment {

/// Sets each sum's `rgb` to the total that `add(row, work, sums)` adds over all rows, divided by the integral of its
/// lobe. `Work` holds the buffers of one thread.
template <class Work, class Add>
void sum_rows(int rows, const Add& add, std::span<TexelSum> sums)
{
    std::vector<TexelSum> none(sums.begin(), sums.end());
    for (TexelSum& sum : none)
        sum.rgb[0] = sum.rgb[1] = sum.rgb[2] = 0.0;
    const auto add_range = [&](const tbb::blocked_range<int>& range, std::vector<TexelSum> total) {
        Work work;
        for (int row = range.begin(); row < range.end(); ++row)
            add(row, work, total);
        return total;
    };
    const auto join = [](std::vector<TexelSum> a, const std::vector<TexelSum>& b) {
        for (std::size_t i = 0; i < a.size(); ++i)
            for (int k = 0; k < 3; ++k)
                a[i].rgb[k] += b[i].rgb[k];
        return a;
    };
    const std::vector<TexelSum> all =
        tbb::parallel_reduce(tbb::blocked_range<int>(0, rows, 32), none, add_range, join);
    for (std::size_t i = 0; i < sums.size(); ++i)
        for (int k = 0; k < 3; ++k)
            sums[i].rgb[k] = all[i].rgb[k] / sums[i].lobe.integral();
}

} // namespace lambent::environment
