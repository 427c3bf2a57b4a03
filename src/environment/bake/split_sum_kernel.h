// The part of bake_split_sum_table that runs on lanes.
#pragma once

#include <cstddef>
#include <vector>

namespace lambent::environment {

/// Points at which the integral over visible normals is evaluated. Heights are shares of the range that can reflect
/// upwards.
struct SplitSumPoints {
    struct Height {
        float height, weight; ///< the weights of all points add up to 1
    };
    struct Azimuth {
        float cosine, sine;
    };
    std::vector<Height> heights;
    std::vector<Azimuth> azimuths;
};

/// One row of the table: three floats per texel.
struct SplitSumRow {
    const float* cosines;
    float* texels;
    std::size_t count;
    float alpha;
};
void split_sum_row(const SplitSumRow& row, const SplitSumPoints& points);

} // namespace lambent::environment
