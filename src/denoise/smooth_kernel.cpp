#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "denoise/smooth_kernel.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"

#include "denoise/rows.h"

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace lambent::denoise::HWY_NAMESPACE {
namespace {

#include "wide/wide.h"
#include "denoise/wide_weights.h"

using Lanes = hn::Vec<FloatTag>;

// The neighbours of a vector of pixels that have a weight in any lane.
struct Taps {
    Lanes weights[25];
    const float* from[25]; // their first plane
    int count;
};

// Binomial weights times likenesses, of the 5x5 neighbours of the pixels from column x on.
HWY_INLINE void find_taps(const SmoothRow& row, int x, Real power, Taps& taps)
{
    constexpr float binomial[] = {0.0625f, 0.25f, 0.375f, 0.25f, 0.0625f};
    const GuidesAt center = guides_at(row.guides[2] + x, row.pitch);
    taps.count = 0;
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 5; ++i) {
            const int dx = (i - 2) * row.step, dy = (j - 2) * row.step;
            Real weight = binomial[j] * binomial[i];
            if (i != 2 || j != 2) {
                const GuidesAt other = guides_at(row.guides[static_cast<size_t>(j)] + x + dx, row.pitch);
                weight =
                    weight * likeness(center, other, power, static_cast<float>(dx), static_cast<float>(dy));
                if (none(weight > 0.0))
                    continue;
            }
            taps.weights[taps.count] = weight.v;
            taps.from[taps.count++] = row.from[static_cast<size_t>(j)] + x + dx;
        }
}

// Weighed sums of `planes` planes from `first` on, stored at `to` times `scale`.
template <int planes>
HWY_INLINE void sum_planes(const Taps& taps, ptrdiff_t first, ptrdiff_t pitch, Real scale, float* to)
{
    Lanes sums[planes];
    for (int c = 0; c < planes; ++c)
        sums[c] = hn::Zero(FloatTag());
    for (int t = 0; t < taps.count; ++t) {
        const float* const from = taps.from[t] + first * pitch;
        for (int c = 0; c < planes; ++c)
            sums[c] = hn::MulAdd(taps.weights[t], hn::LoadU(FloatTag(), from + c * pitch), sums[c]);
    }
    for (int c = 0; c < planes; ++c)
        hn::StoreU(hn::Mul(sums[c], scale.v), FloatTag(), to + (first + c) * pitch);
}

} // namespace

HWY_FLATTEN void smooth_row(const SmoothRow& row)
{
    Taps taps;
    for (int x = 0; x < row.columns; x += static_cast<int>(lane_count)) {
        float* const to = row.to + x;
        const Real covered = load(row.guides[2] + covered_plane * row.pitch + x);
        if (none(covered > 0.0)) {
            for (int c = 0; c < row.planes; ++c)
                store(Real(0.0), to + c * row.pitch);
            continue;
        }
        const Real power = row.lobe ? load(row.guides[2] + power_plane * row.pitch + x) : Real(surface_power);
        find_taps(row, x, power, taps);
        sum_planes<5>(taps, 0, row.pitch, covered, to);
        if (row.planes == most_sum_planes) {
            sum_planes<5>(taps, 5, row.pitch, covered, to);
            sum_planes<5>(taps, 10, row.pitch, covered, to);
        } else {
            sum_planes<4>(taps, 5, row.pitch, covered, to);
            sum_planes<4>(taps, 9, row.pitch, covered, to);
        }
    }
}

HWY_FLATTEN void compare_neighbours(const LikenessRow& row)
{
    for (int x = 0; x < row.columns; x += static_cast<int>(lane_count)) {
        const GuidesAt center = guides_at(row.guides[0] + x, row.pitch);
        // Where one of the two is not covered the weight is 0 already, or the result is not used.
        if (none(load(row.guides[0] + covered_plane * row.pitch + x) > 0.0)) {
            for (int c = 0; c < likeness_planes; ++c)
                store(Real(0.0), row.to + x + c * row.pitch);
            continue;
        }
        for (int pool = 0; pool < pool_count; ++pool)
            for (int d = 0; d < direction_count; ++d) {
                const int dx = direction_x[d] << pool, dy = direction_y[d] << pool;
                const GuidesAt other = guides_at(row.guides[static_cast<size_t>(dy)] + x + dx, row.pitch);
                store(likeness(center, other, surface_power, static_cast<float>(dx), static_cast<float>(dy)),
                      row.to + x + (direction_count * pool + d) * row.pitch);
            }
    }
}

} // namespace lambent::denoise::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::denoise {

HWY_EXPORT(smooth_row);
HWY_EXPORT(compare_neighbours);

void smooth_row(const SmoothRow& row)
{
    HWY_DYNAMIC_DISPATCH(smooth_row)(row);
}

void compare_neighbours(const LikenessRow& row)
{
    HWY_DYNAMIC_DISPATCH(compare_neighbours)(row);
}

} // namespace lambent::denoise
#endif
