#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "environment/panorama/pack_row.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"

#include "environment/panorama/pack_row.h"
#include "environment/panorama/packed_texel.h"

HWY_BEFORE_NAMESPACE();
namespace lambent::environment::HWY_NAMESPACE {
namespace {

#include "wide/wide.h"

} // namespace

HWY_FLATTEN void pack_row(const float* rgb, int count, float factor, uint32_t* texels)
{
    int x = 0;
    for (; x + static_cast<int>(lane_count) <= count; x += static_cast<int>(lane_count)) {
        vec3 c(0.0);
        hn::LoadInterleaved3(FloatTag(), rgb + 3 * x, c.x.v, c.y.v, c.z.v);
        c = min(Real(factor) * c, vec3(65408.0));
        const Real largest = max(c.x, max(c.y, c.z));
        const Int floor_exponent = hn::Sub(hn::ShiftRight<23>(bits(largest)), integer(127));
        const Int exponent = hn::Max(floor_exponent, integer(-16));
        const Real scale = from_bits(hn::ShiftLeft<23>(hn::Sub(integer(127 + 8), exponent)));
        // A mantissa that rounds up to 512 needs the next exponent.
        const Mask carry = largest * scale + 0.5 >= 512.0;
        const Real final_scale = select(carry, 0.5 * scale, scale);
        const Int step = hn::IfThenElseZero(hn::RebindMask(IntTag(), carry.m), integer(1));
        const Int field = hn::Add(hn::Add(exponent, step), integer(16));
        const Real half(image::round_half_up);
        const Int r = truncated(c.x * final_scale + half), g = truncated(c.y * final_scale + half),
                  b = truncated(c.z * final_scale + half);
        const Int packed =
            hn::Or(hn::Or(hn::ShiftLeft<27>(field), hn::ShiftLeft<18>(b)), hn::Or(hn::ShiftLeft<9>(g), r));
        hn::StoreU(packed, IntTag(), reinterpret_cast<int32_t*>(texels + x));
    }
    for (; x < count; ++x)
        texels[x] = pack_rgb9e5(rgb[3 * x] * factor, rgb[3 * x + 1] * factor, rgb[3 * x + 2] * factor);
}

} // namespace lambent::environment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::environment {

HWY_EXPORT(pack_row);

void pack_row(const float* rgb, int count, float factor, std::uint32_t* texels)
{
    HWY_DYNAMIC_DISPATCH(pack_row)(rgb, count, factor, texels);
}

} // namespace lambent::environment
#endif
