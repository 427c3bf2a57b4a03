#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "denoise/prepare_kernel.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"

#include "denoise/prepare_rows.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace lambent::denoise::HWY_NAMESPACE {
namespace {

#include "wide/wide.h"

// The caller's planes end where the picture does: what is left of the last vector is 0.
HWY_INLINE Real load_within(const float* row, int x, int columns)
{
    if (x + static_cast<int>(lane_count) <= columns)
        return load(row + x);
    alignas(64) float rest[max_lanes] = {};
    std::copy(row + x, row + columns, rest);
    return load(rest);
}

// Where the span begins in a plane of the caller's.
const float* start_of(const Plane& plane, const RowSpan& span, int width)
{
    return plane.data() + static_cast<ptrdiff_t>(span.y) * width + span.first;
}

HWY_INLINE void clear(float* to, int planes, ptrdiff_t pitch)
{
    for (int c = 0; c < planes; ++c)
        store(Real(0.0), to + c * pitch);
}

// A surface's change of depth from pixel to pixel.
HWY_INLINE Real slope_between(Real depth, Real before, Real after, Mask has_before, Mask has_after)
{
    const Real backward = depth - before, forward = after - depth;
    const Real lesser = select(abs(backward) < abs(forward), backward, forward);
    const Real slope =
        select(has_before, select(has_after, lesser, backward), select(has_after, forward, 0.0));
    return clamp(slope, -0.1 * depth, 0.1 * depth);
}

// The caller's planes of one channel, from the span's first column on.
struct Sources {
    const float *exact, *albedo; // albedo null: 1
    const float *unshadowed[2], *found[2];
};

Sources sources_of(const LightJob& job, const RowSpan& span, int channel)
{
    const auto c = static_cast<size_t>(channel);
    const int width = job.picture.width;
    const Light& light = job.light;
    Sources from{start_of(light.exact[c], span, width), nullptr, {}, {}};
    if (!light.albedo[c].empty())
        from.albedo = start_of(light.albedo[c], span, width);
    for (size_t half = 0; half < 2; ++half) {
        from.unshadowed[half] = start_of(light.halves[half].unshadowed[c], span, width);
        from.found[half] = start_of(light.halves[half].found[c], span, width);
    }
    return from;
}

// One channel of a vector of pixels of some weight, to the planes of its first one.
HWY_INLINE void prepare_channel(const Sources& from, const RowSpan& span, int x, Real weight,
                                PreparedLight to)
{
    // Pixels of little albedo weigh little, since what they received is known little.
    constexpr double least_albedo = 1.0e-5, little_albedo = 0.01;
    const Mask covered = weight > 0.0;
    const auto given = [&](const float* plane)
                           HWY_ATTR { return select(covered, load_within(plane, x, span.columns), 0.0); };
    Real albedo = 1.0, scale = weight;
    if (from.albedo) {
        albedo = max(given(from.albedo), least_albedo);
        scale = weight / (albedo + little_albedo);
    }
    store(given(from.exact), to.given + given_exact * span.pitch + x);
    store(albedo, to.given + given_albedo * span.pitch + x);
    for (int half = 0; half < 2; ++half) {
        const Real unshadowed = given(from.unshadowed[half]), found = given(from.found[half]);
        float* const sums = to.sums + 6 * half * span.pitch + x;
        store(scale * unshadowed, sums + sum_unshadowed * span.pitch);
        store(scale * (found - unshadowed), sums + sum_change * span.pitch);
    }
    if (from.albedo)
        store(scale * albedo, to.sums + sum_weight * span.pitch + x);
}

} // namespace

HWY_FLATTEN void prepare_guides(const Guides& guides, int width, const RowSpan& span, float* to)
{
    const float* const coverage = start_of(guides.coverage, span, width);
    const Plane* const copied[] = {&guides.normal[0], &guides.normal[1], &guides.normal[2], &guides.depth,
                                   &guides.metalness};
    constexpr int planes[] = {normal_plane, normal_plane + 1, normal_plane + 2, depth_plane, metalness_plane};
    const float* const alphas = start_of(guides.alpha, span, width);
    for (int x = 0; x < span.columns; x += static_cast<int>(lane_count)) {
        const Mask covered = load_within(coverage, x, span.columns) > 0.0;
        if (none(covered)) {
            clear(to + x, guide_planes, span.pitch);
            continue;
        }
        store(select(covered, 1.0, 0.0), to + covered_plane * span.pitch + x);
        for (int i = 0; i < 5; ++i)
            store(select(covered, load_within(start_of(*copied[i], span, width), x, span.columns), 0.0),
                  to + planes[i] * span.pitch + x);
        // Narrow lobes see other things when the normal turns by less than their width.
        const Real alpha = select(covered, max(load_within(alphas, x, span.columns), 0.0), 0.0);
        store(sqrt(alpha), to + roughness_plane * span.pitch + x);
        store(clamp(2.0 / max(alpha * alpha, 1.0e-6), 32.0, 1.0e5), to + power_plane * span.pitch + x);
    }
}

HWY_FLATTEN void prepare_slopes(const float* above, float* row, const float* below, const RowSpan& span)
{
    const auto depth = [&](const float* at) HWY_ATTR { return load(at + depth_plane * span.pitch); };
    const auto covered = [&](const float* at)
                             HWY_ATTR { return load(at + covered_plane * span.pitch) > 0.0; };
    for (int x = 0; x < span.columns; x += static_cast<int>(lane_count)) {
        float* const here = row + x;
        if (none(covered(here)))
            continue; // 0 already
        store(slope_between(depth(here), depth(here - 1), depth(here + 1), covered(here - 1),
                            covered(here + 1)),
              here + slope_x_plane * span.pitch);
        store(slope_between(depth(here), depth(above + x), depth(below + x), covered(above + x),
                            covered(below + x)),
              here + slope_y_plane * span.pitch);
    }
}

HWY_FLATTEN void prepare_light(const LightJob& job, const RowSpan& span, PreparedLight to)
{
    const float* const coverages = start_of(job.picture.guides.coverage, span, job.picture.width);
    const float* const counts = start_of(job.picture.count, span, job.picture.width);
    const Sources from[] = {sources_of(job, span, 0), sources_of(job, span, 1), sources_of(job, span, 2)};
    const int sum_planes = from[0].albedo ? sum_weight + 3 : sum_weight + 1;
    for (int x = 0; x < span.columns; x += static_cast<int>(lane_count)) {
        const Real coverage = load_within(coverages, x, span.columns);
        if (none(coverage > 0.0)) {
            clear(to.given + x, given_planes, span.pitch);
            clear(to.sums + x, sum_planes, span.pitch);
            continue;
        }
        const Real weight = select(coverage > 0.0, coverage * load_within(counts, x, span.columns), 0.0);
        store(weight, to.given + given_weight * span.pitch + x);
        for (int c = 0; c < 3; ++c)
            prepare_channel(from[c], span, x, weight, {to.given + c * span.pitch, to.sums + c * span.pitch});
        if (!from[0].albedo)
            store(weight, to.sums + sum_weight * span.pitch + x);
    }
    job.shares.fill(span.y, span.first, span.columns, to.given + given_share * span.pitch);
}

} // namespace lambent::denoise::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::denoise {

HWY_EXPORT(prepare_guides);
HWY_EXPORT(prepare_slopes);
HWY_EXPORT(prepare_light);

void prepare_guides(const Guides& guides, int width, const RowSpan& span, float* to)
{
    HWY_DYNAMIC_DISPATCH(prepare_guides)(guides, width, span, to);
}

void prepare_slopes(const float* above, float* row, const float* below, const RowSpan& span)
{
    HWY_DYNAMIC_DISPATCH(prepare_slopes)(above, row, below, span);
}

void prepare_light(const LightJob& job, const RowSpan& span, PreparedLight to)
{
    HWY_DYNAMIC_DISPATCH(prepare_light)(job, span, to);
}

} // namespace lambent::denoise
#endif
