#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "denoise/choice_kernel.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"

#include "denoise/rows.h"

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace lambent::denoise::HWY_NAMESPACE {
namespace {

#include "wide/wide.h"

using Lanes = hn::Vec<FloatTag>;

// What is known of one channel of a vector of pixels.
struct GivenAt {
    Real exact, albedo, share;
};

// One channel of both halves: what each adds to the exact light.
struct Changes {
    Real first, second;
};

struct Estimates {
    Changes control, ratio;
};

HWY_INLINE Changes select(Mask m, const Changes& yes, const Changes& no)
{
    return {select(m, yes.first, no.first), select(m, yes.second, no.second)};
}

// One half of a level at some pixels, one channel: pooled sums.
struct Pooled {
    Real unshadowed, change, scale; // scale: albedo over the sums' weight
};

// The share of the exact light that is not a control variate is taken from the samples instead.
HWY_INLINE Real by_difference(const GivenAt& given, const Pooled& pooled)
{
    return pooled.scale * pooled.change +
           (1.0 - given.share) * (pooled.scale * pooled.unshadowed - given.exact);
}

// Change that a ratio of sums gives to exact light; what is above the ratio's limit is kept as an amount. Where next to no
// light is pooled the ratio says nothing, and the difference is taken.
HWY_INLINE Real by_ratio(const GivenAt& given, const Pooled& pooled, Real difference, Real limit)
{
    const Real most = limit - 1.0;
    const Mask valid = pooled.scale * pooled.unshadowed > 1.0e-3 * given.exact;
    const Real ratio = pooled.change / select(valid, pooled.unshadowed, 1.0);
    const Real beyond = pooled.scale * max(pooled.change - most * pooled.unshadowed, 0.0);
    return select(valid, given.exact * clamp(ratio, -1.0, most) + beyond, difference);
}

// Both estimates of channel c of a level whose sums for the pixels are at `sums`.
HWY_INLINE Estimates estimates_at(const CandidateRow& row, const float* sums, const GivenAt& given, int c)
{
    const auto sum = [&](int plane) HWY_ATTR { return load(sums + (plane + c) * row.pitch); };
    const Real weight = load(sums + (sum_weight + (row.weight_planes == 3 ? c : 0)) * row.pitch);
    const Real scale = given.albedo / max(weight, 1.0e-30);
    const Pooled first = {sum(sum_unshadowed), sum(sum_change), scale},
                 second = {sum(6 + sum_unshadowed), sum(6 + sum_change), scale};
    const Changes control = {by_difference(given, first), by_difference(given, second)};
    return {control,
            {by_ratio(given, first, control.first, row.ratio_limit),
             by_ratio(given, second, control.second, row.ratio_limit)}};
}

HWY_INLINE GivenAt given_at(const CandidateRow& row, int x, int c)
{
    return {load(row.given + x + (given_exact + c) * row.pitch),
            load(row.given + x + (given_albedo + c) * row.pitch),
            load(row.given + x + given_share * row.pitch)};
}

// How much errors count: less where unshadowed light is beyond white. Known without noise, it favours no candidate.
HWY_INLINE Real sight_of(const CandidateRow& row, const GivenAt& given)
{
    return min(row.cut / max(given.exact, 1.0e-30), 1.0);
}

// Twice the squared errors of either half against the other's target, one channel. Sum and difference, so that halves
// swapped give the same bits even where products and additions are fused.
HWY_INLINE Lanes error_of(const Changes& filtered, const Changes& target, Real sight)
{
    const Real a = filtered.first - target.second, b = filtered.second - target.first;
    const Real sum = sight * (a + b), difference = sight * (a - b);
    return (sum * sum + difference * difference).v;
}

HWY_INLINE Lanes weight_at(const Neighbourhood& near, int x, int direction, bool forward)
{
    const int step = 1 << near.pool, dx = direction_x[direction] * step;
    const float* const plane = near.likeness[forward || direction_y[direction] == 0] +
                               (direction_count * near.pool + direction) * near.pitch;
    return hn::LoadU(FloatTag(), plane + x - (forward ? 0 : dx));
}

// Calls visit(row of near.from, offset, weight) for the 3x3 neighbours of the pixels from column x on.
template <class Visit>
HWY_INLINE void for_each_near(const Neighbourhood& near, int x, Visit&& visit)
{
    const int step = 1 << near.pool;
    visit(1, 0, hn::Set(FloatTag(), 0.25f));
    for (int d = 0; d < direction_count; ++d) {
        const Lanes share =
            hn::Set(FloatTag(), direction_x[d] != 0 && direction_y[d] != 0 ? 0.0625f : 0.125f);
        const int dx = direction_x[d] * step;
        visit(1 + direction_y[d], dx, hn::Mul(share, weight_at(near, x, d, true)));
        visit(1 - direction_y[d], -dx, hn::Mul(share, weight_at(near, x, d, false)));
    }
}

template <int planes>
HWY_INLINE void pool_planes(const Neighbourhood& near, ptrdiff_t plane, int x, Real scale, float* to)
{
    Lanes sums[planes];
    for (int c = 0; c < planes; ++c)
        sums[c] = hn::Zero(FloatTag());
    for_each_near(near, x, [&](int j, int offset, Lanes weight) HWY_ATTR {
        const float* const from = near.from[static_cast<size_t>(j)] + plane * near.pitch + x + offset;
        for (int c = 0; c < planes; ++c)
            sums[c] = hn::MulAdd(weight, hn::LoadU(FloatTag(), from + c * near.pitch), sums[c]);
    });
    for (int c = 0; c < planes; ++c)
        hn::StoreU(hn::Mul(sums[c], scale.v), FloatTag(), to + (plane + c) * near.pitch + x);
}

// Shares of the candidates in the choices around the pixels from column x on; they add up to 1 for covered pixels.
// Neighbours that are not covered have no choice: -1.
HWY_INLINE void find_shares(const Neighbourhood& near, int x, Lanes* shares)
{
    for (int k = 0; k < candidate_count; ++k)
        shares[k] = hn::Zero(FloatTag());
    for_each_near(near, x, [&](int j, int offset, Lanes weight) HWY_ATTR {
        const Lanes choice = hn::LoadU(FloatTag(), near.from[static_cast<size_t>(j)] + x + offset);
        for (int k = 0; k < candidate_count; ++k)
            shares[k] = hn::Add(shares[k], hn::IfThenElseZero(hn::Eq(choice, Real(k).v), weight));
    });
    Real total = 0.0;
    for (int k = 0; k < candidate_count; ++k)
        total += shares[k];
    const Real scale = 1.0 / max(total, 1.0e-30);
    for (int k = 0; k < candidate_count; ++k)
        shares[k] = hn::Mul(shares[k], scale.v);
}

} // namespace

HWY_FLATTEN void pool_row(const Neighbourhood& near, int planes, float* to)
{
    for (int x = 0; x < near.columns; x += static_cast<int>(lane_count)) {
        const Real covered = load(near.guides + covered_plane * near.pitch + x);
        if (none(covered > 0.0)) {
            for (int c = 0; c < planes; ++c)
                store(Real(0.0), to + c * near.pitch + x);
        } else if (planes == target_count) {
            pool_planes<target_count>(near, 0, x, covered, to);
        } else {
            pool_planes<5>(near, 0, x, covered, to);
            pool_planes<5>(near, 5, x, covered, to);
        }
    }
}

HWY_FLATTEN void choose_row(const ChoiceRow& row, float* choices)
{
    for (int x = 0; x < row.columns; x += static_cast<int>(lane_count)) {
        Real least = load(row.errors + x), choice = 0.0;
        for (int k = 1; k < row.planes; ++k) {
            const Real error = load(row.errors + k * row.pitch + x);
            choice = select(error < least, Real(k), choice);
            least = min(error, least);
        }
        const Real covered = load(row.guides + covered_plane * row.pitch + x);
        store(select(covered > 0.0, choice, -1.0), choices + x);
    }
}

HWY_FLATTEN void find_target_errors(const CandidateRow& row, float* errors)
{
    for (int x = 0; x < row.columns; x += static_cast<int>(lane_count)) {
        const Real weight = load(row.given + given_weight * row.pitch + x);
        Lanes sums[target_count] = {hn::Zero(FloatTag()), hn::Zero(FloatTag()), hn::Zero(FloatTag())};
        for (int c = 0; c < 3 && any_of(weight > 0.0); ++c) {
            const GivenAt given = given_at(row, x, c);
            const Real sight = sight_of(row, given);
            const Changes unfiltered = estimates_at(row, row.sums[0] + x, given, c).control;
            const Estimates e = estimates_at(row, row.sums[1] + x, given, c);
            sums[0] = hn::Add(sums[0], error_of(unfiltered, unfiltered, sight));
            sums[1] = hn::Add(sums[1], error_of(e.control, unfiltered, sight));
            sums[2] = hn::Add(sums[2], error_of(e.ratio, unfiltered, sight));
        }
        for (int k = 0; k < target_count; ++k)
            store(weight * Real(sums[k]), errors + k * row.pitch + x);
    }
}

HWY_FLATTEN void find_errors(const CandidateRow& row, const float* targets, float* errors)
{
    for (int x = 0; x < row.columns; x += static_cast<int>(lane_count)) {
        const Real weight = load(row.given + given_weight * row.pitch + x);
        const Real named = load(targets + x);
        Lanes sums[candidate_count];
        for (int k = 0; k < candidate_count; ++k)
            sums[k] = hn::Zero(FloatTag());
        for (int c = 0; c < 3 && any_of(weight > 0.0); ++c) {
            const GivenAt given = given_at(row, x, c);
            const Real sight = sight_of(row, given);
            const Changes unfiltered = estimates_at(row, row.sums[0] + x, given, c).control;
            const Estimates first = estimates_at(row, row.sums[1] + x, given, c);
            const Changes target =
                select(named > 0.5, select(named > 1.5, first.ratio, first.control), unfiltered);
            for (int level = 0; level < level_count; ++level) {
                const Estimates e = estimates_at(row, row.sums[static_cast<size_t>(level)] + x, given, c);
                sums[2 * level] = hn::Add(sums[2 * level], error_of(e.control, target, sight));
                sums[2 * level + 1] = hn::Add(sums[2 * level + 1], error_of(e.ratio, target, sight));
            }
        }
        for (int k = 0; k < candidate_count; ++k)
            store(weight * Real(sums[k]), errors + k * row.pitch + x);
    }
}

HWY_FLATTEN void blend_row(const CandidateRow& row, const Neighbourhood& near, float* to)
{
    Lanes shares[candidate_count];
    for (int x = 0; x < row.columns; x += static_cast<int>(lane_count)) {
        const Real covered = load(row.guides + covered_plane * row.pitch + x);
        const bool empty = none(covered > 0.0);
        if (!empty)
            find_shares(near, x, shares);
        for (int c = 0; c < 3; ++c) {
            Changes sum{0.0, 0.0};
            const GivenAt given = given_at(row, x, c);
            for (int level = 0; level < level_count && !empty; ++level) {
                const Estimates e = estimates_at(row, row.sums[static_cast<size_t>(level)] + x, given, c);
                const Real control = shares[2 * level], ratio = shares[2 * level + 1];
                sum.first += control * e.control.first + ratio * e.ratio.first;
                sum.second += control * e.control.second + ratio * e.ratio.second;
            }
            const Real light = max(given.exact + 0.5 * (sum.first + sum.second), 0.0);
            store(covered * light, to + x + (result_light + c) * row.pitch);
            store(covered * (sum.first - sum.second), to + x + (result_gap + c) * row.pitch);
        }
    }
}

} // namespace lambent::denoise::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::denoise {

HWY_EXPORT(pool_row);
HWY_EXPORT(choose_row);
HWY_EXPORT(find_target_errors);
HWY_EXPORT(find_errors);
HWY_EXPORT(blend_row);

void pool_row(const Neighbourhood& near, int planes, float* to)
{
    HWY_DYNAMIC_DISPATCH(pool_row)(near, planes, to);
}

void choose_row(const ChoiceRow& row, float* choices)
{
    HWY_DYNAMIC_DISPATCH(choose_row)(row, choices);
}

void find_target_errors(const CandidateRow& row, float* errors)
{
    HWY_DYNAMIC_DISPATCH(find_target_errors)(row, errors);
}

void find_errors(const CandidateRow& row, const float* targets, float* errors)
{
    HWY_DYNAMIC_DISPATCH(find_errors)(row, targets, errors);
}

void blend_row(const CandidateRow& row, const Neighbourhood& near, float* to)
{
    HWY_DYNAMIC_DISPATCH(blend_row)(row, near, to);
}

} // namespace lambent::denoise
#endif
