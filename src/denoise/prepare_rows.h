// The first rows of the stream: from the caller's planes to weighed sums and guides.
#pragma once

#include "denoise/rows.h"
#include "denoise/tile_stream.h"

namespace lambent::denoise {

/// Columns [first, first + columns) of row y.
struct RowSpan {
    int y, first, columns;
    std::ptrdiff_t pitch; ///< floats between planes of what is written
};

/// Guides without slopes. Pixels that are not covered get 0 in every plane, here and below.
void prepare_guides(const Guides& guides, int width, const RowSpan& span, float* to);

/// Slopes from the rows above, of and below: in each direction the smaller of the differences to the two covered
/// neighbours, so that the surface behind a silhouette has no part in it; at most a tenth of the depth per pixel.
void prepare_slopes(const float* above, float* row, const float* below, const RowSpan& span);

/// What is known (GivenPlane), and the sums of the unfiltered light (SumPlane), at column 0 of the first plane of each.
struct PreparedLight {
    float *given, *sums;
};
void prepare_light(const LightJob& job, const RowSpan& span, PreparedLight to);

} // namespace lambent::denoise
