#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "environment/bake/prefilter_kernel.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"

#include "environment/bake/light_points.h"
#include "environment/bake/prefilter.h"

#include <cmath>
#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace lambent::environment::HWY_NAMESPACE {
namespace {

#include "wide/wide.h"

struct GgxWeight {
    float alpha2;

    HWY_INLINE LobeWeight at(Real c, Real versine) const { return lobe_weight_ggx(c, versine, alpha2); }
};

struct PhongWeight {
    float exponent;

    HWY_INLINE LobeWeight at(Real c, Real versine) const { return lobe_weight_phong(c, versine, exponent); }
};

// Lanes of texels, and the light that arrives at them.
struct Texels {
    Real x, y, z, r = 0.0, g = 0.0, b = 0.0, all = 0.0;

    HWY_INLINE Texels(const PrefilterPatch& patch, size_t at)
        : x(load(patch.x + at)), y(load(patch.y + at)), z(load(patch.z + at))
    {
    }

    template <class Shape>
    HWY_INLINE void add(const LightCell& cell, const Shape& shape)
    {
        const Real dx = x - Real(cell.x), dy = y - Real(cell.y), dz = z - Real(cell.z);
        // 1 - cosine, from the chord: exact where the lobe is narrow.
        const Real versine = 0.5 * (dx * dx + dy * dy + dz * dz), c = 1.0 - versine;
        const LobeWeight weight = shape.at(c, versine);
        const Real w = select(c > 0.0, max(weight.value + Real(cell.variance) * weight.curvature, 0.0), 0.0);
        r += w * Real(cell.r);
        g += w * Real(cell.g);
        b += w * Real(cell.b);
        all += w * Real(cell.area);
    }

    HWY_INLINE void store_to(PrefilterPatch::Sums& sums, size_t at) const
    {
        store(load(sums.r + at) + r, sums.r + at);
        store(load(sums.g + at) + g, sums.g + at);
        store(load(sums.b + at) + b, sums.b + at);
        store(load(sums.weight + at) + all, sums.weight + at);
    }
};

template <class Shape>
HWY_INLINE void add(std::span<const LightCell> cells, const Shape& shape, const PrefilterTexels& texels)
{
    size_t at = texels.first;
    const size_t end = texels.first + texels.count;
    // Two vectors of texels at once share the loads of the cells.
    for (; at + 2 * lane_count <= end; at += 2 * lane_count) {
        Texels first(texels.patch, at), second(texels.patch, at + lane_count);
        for (const LightCell& cell : cells) {
            first.add(cell, shape);
            second.add(cell, shape);
        }
        first.store_to(texels.sums, at);
        second.store_to(texels.sums, at + lane_count);
    }
    for (; at < end; at += lane_count) {
        Texels only(texels.patch, at);
        for (const LightCell& cell : cells)
            only.add(cell, shape);
        only.store_to(texels.sums, at);
    }
}

using DoubleTag = hn::ScalableTag<double>;

void add_by_definition(const LightPoints& p, LightRange range, TexelSum& sum)
{
    for (size_t i = range.begin; i < range.end; ++i) {
        const double w = sum.lobe.weight(sum.x * p.x[i] + sum.y * p.y[i] + sum.z * p.z[i]);
        sum.rgb[0] += w * p.r[i];
        sum.rgb[1] += w * p.g[i];
        sum.rgb[2] += w * p.b[i];
    }
}

void add_ggx(const LightPoints& p, LightRange range, TexelSum& sum)
{
    const DoubleTag d;
    const double a2 = sum.lobe.alpha * sum.lobe.alpha;
    const auto nx = hn::Set(d, sum.x), ny = hn::Set(d, sum.y), nz = hn::Set(d, sum.z);
    const auto A = hn::Set(d, 0.5 * (1.0 + a2)), B = hn::Set(d, 0.5 * (1.0 - a2)), none = hn::Zero(d);
    auto r = none, g = none, b = none;
    for (size_t i = range.begin; i < range.end; i += hn::Lanes(d)) {
        const auto in_plane = hn::MulAdd(nx, hn::LoadU(d, &p.x[i]), hn::Mul(nz, hn::LoadU(d, &p.z[i])));
        const auto c = hn::MulAdd(ny, hn::LoadU(d, &p.y[i]), in_plane);
        const auto q = hn::NegMulAdd(B, c, A);
        const auto counted = hn::And(hn::FirstN(d, range.end - i), hn::Gt(c, none));
        if (hn::AllFalse(d, counted))
            continue;
        const auto w = hn::IfThenElseZero(counted, hn::Div(c, hn::Mul(q, q)));
        r = hn::MulAdd(w, hn::LoadU(d, &p.r[i]), r);
        g = hn::MulAdd(w, hn::LoadU(d, &p.g[i]), g);
        b = hn::MulAdd(w, hn::LoadU(d, &p.b[i]), b);
    }
    sum.rgb[0] += hn::GetLane(hn::SumOfLanes(d, r));
    sum.rgb[1] += hn::GetLane(hn::SumOfLanes(d, g));
    sum.rgb[2] += hn::GetLane(hn::SumOfLanes(d, b));
}

} // namespace

HWY_FLATTEN void add_cells(std::span<const LightCell> cells, const PrefilterLobe& lobe,
                           const PrefilterTexels& texels)
{
    if (lobe.phong)
        add(cells, PhongWeight{static_cast<float>(lobe.exponent)}, texels);
    else
        add(cells, GgxWeight{static_cast<float>(lobe.alpha * lobe.alpha)}, texels);
}

HWY_FLATTEN void finish_texels(PrefilterPatch& patch, double integral)
{
    const auto sum_of = [](const PrefilterPatch::Sums& sums, size_t at) HWY_ATTR {
        const LobeSum sum = {vec3(load(sums.r + at), load(sums.g + at), load(sums.b + at)),
                             load(sums.weight + at)};
        return sum;
    };
    for (size_t at = 0; at < PrefilterPatch::tile * patch.tiles; at += lane_count) {
        const vec3 mean = mean_of_lobe(sum_of(patch.dim, at), sum_of(patch.bright, at), integral);
        store(mean.x, patch.dim.r + at);
        store(mean.y, patch.dim.g + at);
        store(mean.z, patch.dim.b + at);
    }
}

HWY_FLATTEN void add_points(const LightPoints& points, LightRange range, TexelSum& sum)
{
    if (sum.lobe.phong)
        add_by_definition(points, range, sum);
    else
        add_ggx(points, range, sum);
}

} // namespace lambent::environment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::environment {

HWY_EXPORT(add_cells);
HWY_EXPORT(finish_texels);
HWY_EXPORT(add_points);

void add_cells(std::span<const LightCell> cells, const PrefilterLobe& lobe, const PrefilterTexels& texels)
{
    HWY_DYNAMIC_DISPATCH(add_cells)(cells, lobe, texels);
}

void finish_texels(PrefilterPatch& patch, double integral)
{
    HWY_DYNAMIC_DISPATCH(finish_texels)(patch, integral);
}

void add_points(const LightPoints& points, LightRange range, TexelSum& sum)
{
    HWY_DYNAMIC_DISPATCH(add_points)(points, range, sum);
}

} // namespace lambent::environment
#endif
