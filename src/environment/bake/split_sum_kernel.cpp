#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "environment/bake/split_sum_kernel.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"

#include "environment/bake/split_sum_kernel.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace lambent::environment::HWY_NAMESPACE {
namespace {

#include "wide/wide.h"

// Both parts of the albedo for lanes of NV, by quadrature over the visible normals of sample_visible_ggx.
vec2 albedo(Real NV, float alpha, const SplitSumPoints& points)
{
    const vec3 view(sqrt(max((1.0 - NV) * (1.0 + NV), 0.0)), 0.0, NV);
    const vec3 stretched = stretched_view(view, vec2(alpha));
    const Real share = reflecting_share_ggx(view, vec2(alpha));
    Real all = 0.0, grazing = 0.0;
    for (const SplitSumPoints::Height& h : points.heights)
        for (const SplitSumPoints::Azimuth& a : points.azimuths) {
            const VisibleFacet facet =
                sample_visible_ggx(stretched, vec2(alpha), vec3(share * Real(h.height), a.cosine, a.sine));
            const Real VH = dot(view, facet.normal);
            const Real NL = 2.0 * VH * facet.normal.z - NV;
            const Real lit = max(NL, 1.0e-7);
            const Real kept = select(NL > 0.0, Real(h.weight) * shadowing_ggx(lit, NV, alpha), 0.0);
            all += kept;
            grazing += kept * schlick_weight(clamp(VH, 0.0, 1.0));
        }
    return vec2(share * (all - grazing), share * grazing);
}

} // namespace

HWY_FLATTEN void split_sum_row(const SplitSumRow& row, const SplitSumPoints& points)
{
    for (std::size_t x = 0; x < row.count; x += lane_count) {
        alignas(64) float cosines[max_lanes] = {}, scale[max_lanes], bias[max_lanes];
        const std::size_t count = std::min(lane_count, row.count - x);
        for (std::size_t i = 0; i < lane_count; ++i)
            cosines[i] = row.cosines[x + std::min(i, count - 1)];
        const vec2 pair = albedo(load(cosines), row.alpha, points);
        store(pair.x, scale);
        store(pair.y, bias);
        for (std::size_t i = 0; i < count; ++i) {
            float* texel = row.texels + 3 * (x + i);
            texel[0] = scale[i];
            texel[1] = bias[i];
            texel[2] = scale[i] + bias[i];
        }
    }
}

} // namespace lambent::environment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::environment {

HWY_EXPORT(split_sum_row);

void split_sum_row(const SplitSumRow& row, const SplitSumPoints& points)
{
    HWY_DYNAMIC_DISPATCH(split_sum_row)(row, points);
}

} // namespace lambent::environment
#endif
