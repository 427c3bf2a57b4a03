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
using Rows = std::array<const float*, 5>;

// Sums of `planes` planes over 5x5 weighed neighbours of the pixels at `at`, stored at `to` times `scale`.
template <int planes>
HWY_INLINE void sum_planes(const SmoothRow& row, const Lanes* weights, ptrdiff_t at, Real scale)
{
    Lanes sums[planes];
    for (int c = 0; c < planes; ++c)
        sums[c] = hn::Zero(FloatTag());
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 5; ++i) {
            const float* const from = row.from[static_cast<size_t>(j)] + at + (i - 2) * row.step;
            const Lanes weight = weights[5 * j + i];
            for (int c = 0; c < planes; ++c)
                sums[c] = hn::MulAdd(weight, hn::LoadU(FloatTag(), from + c * row.pitch), sums[c]);
        }
    for (int c = 0; c < planes; ++c)
        hn::StoreU(hn::Mul(sums[c], scale.v), FloatTag(), row.to + at + c * row.pitch);
}

// Binomial weights times likenesses, of the 5x5 neighbours of the pixels from column x on.
HWY_INLINE void find_weights(const SmoothRow& row, int x, Real power, Lanes* weights)
{
    constexpr float binomial[] = {0.0625f, 0.25f, 0.375f, 0.25f, 0.0625f};
    const GuidesAt center = guides_at(row.guides[2] + x, row.pitch);
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 5; ++i) {
            const Real share = binomial[j] * binomial[i];
            const int dx = (i - 2) * row.step, dy = (j - 2) * row.step;
            const GuidesAt other = guides_at(row.guides[static_cast<size_t>(j)] + x + dx, row.pitch);
            weights[5 * j + i] =
                i == 2 && j == 2
                    ? share.v
                    : (share * likeness(center, other, power, static_cast<float>(dx), static_cast<float>(dy)))
                          .v;
        }
}

} // namespace

HWY_FLATTEN void smooth_row(const SmoothRow& row)
{
    Lanes weights[25];
    for (int x = 0; x < row.columns; x += static_cast<int>(lane_count)) {
        const Real covered = load(row.guides[2] + covered_plane * row.pitch + x);
        if (none(covered > 0.0)) {
            for (int c = 0; c < row.planes; ++c)
                store(Real(0.0), row.to + x + c * row.pitch);
            continue;
        }
        const Real power = row.lobe ? load(row.guides[2] + power_plane * row.pitch + x) : Real(surface_power);
        find_weights(row, x, power, weights);
        sum_planes<5>(row, weights, x, covered);
        if (row.planes == most_sum_planes) {
            sum_planes<5>(row, weights, x + 5 * row.pitch, covered);
            sum_planes<5>(row, weights, x + 10 * row.pitch, covered);
        } else {
            sum_planes<4>(row, weights, x + 5 * row.pitch, covered);
            sum_planes<4>(row, weights, x + 9 * row.pitch, covered);
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
