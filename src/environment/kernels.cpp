#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "environment/kernels.cpp"
#include <hwy/foreach_target.h>
#include "wide/highway.h"

#include "environment/kernels.h"

#include <algorithm>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace lambent::environment::HWY_NAMESPACE {
namespace {

#include "wide/wide.h"
#include "environment/wide_cube.h"
#include "environment/wide_panorama.h"

CubeView view(const CubeChain& chain)
{
    return {chain.halfs(), chain.log2_size, chain.levels};
}

// The nearest half, ties to even, of a number from 0 to 65504. Highway's own conversion cuts off where the processor has
// none (SSE4 and portable), which makes all light darker by half a step on average.
Real nearest_half(Real a)
{
    const Int odd = hn::And(hn::ShiftRight<13>(bits(a)), integer(1));
    const Int up = hn::Add(hn::Add(bits(a), integer(0xfff)), odd);
    const Real normal = from_bits(hn::And(up, integer(~0x1fff)));
    // Below 2^-14 steps are of one size, that of the floats from 0.5 on.
    return select(a < 0x1p-14, (a + 0.5) - 0.5, normal);
}

// Cuts what a half cannot hold and stores the first `count` lanes as texels.
void store_halfs(vec3 rgb, size_t count, uint16_t* halfs)
{
    const hn::Rebind<hwy::float16_t, FloatTag> half_tag;
    alignas(64) float interleaved[3 * max_lanes];
    alignas(64) uint16_t rounded[3 * max_lanes];
    const vec3 cut = clamp(rgb, 0.0, 65504.0);
    hn::StoreInterleaved3(nearest_half(cut.x).v, nearest_half(cut.y).v, nearest_half(cut.z).v, FloatTag(),
                          interleaved);
    for (size_t i = 0; i < 3; ++i) {
        const auto values = hn::Load(FloatTag(), interleaved + i * lane_count);
        hn::Store(hn::DemoteTo(half_tag, values), half_tag,
                  reinterpret_cast<hwy::float16_t*>(rounded) + i * lane_count);
    }
    for (size_t i = 0; i < 3 * count; ++i)
        halfs[i] = rounded[i];
}

// The coordinate in [-1, 1] of points `inside` (0 to 1) across the texels x, x + 1, ...
Real face_coordinate(int first, float inside, int size)
{
    const Real x = Real(hn::Iota(FloatTag(), static_cast<float>(first))) + Real(inside);
    return x * Real(2.0f / static_cast<float>(size)) - 1.0;
}

// A vector without its part along the unit vector d, of unit length.
vec3 beside(vec3 v, vec3 d)
{
    return normalize(v - dot(v, d) * d);
}

// A frame about the unit vector d towards a face: its tangents lie between the face's sides as they are seen from there,
// so that it is mirrored where the direction is, and all faces' frames are alike.
mat3 frame_on_face(int face, vec3 d)
{
    const vec3 axis = direction_from_cube(face, 0.0, 0.0);
    const vec3 right = beside(direction_from_cube(face, 1.0, 0.0) - axis, d),
               down = beside(direction_from_cube(face, 0.0, 1.0) - axis, d);
    return mat3(normalize(right + down), normalize(right - down), d);
}

size_t lanes_left(int x, int size)
{
    return std::min(lane_count, static_cast<size_t>(size - x));
}

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
        // Rounding up to 512 takes one more exponent step.
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

HWY_FLATTEN std::array<std::array<double, 5>, 3> row_moments(const Panorama& panorama, int y,
                                                             const AzimuthOrders& orders)
{
    const auto* texels = reinterpret_cast<const int32_t*>(panorama.texels.data()) +
                         static_cast<size_t>(y) * static_cast<size_t>(panorama.width);
    vec3 sums[5] = {vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0)};
    alignas(64) int32_t last[max_lanes] = {}; // no light in the lanes behind the row
    for (int x = 0; x < panorama.width; x += static_cast<int>(lane_count)) {
        const size_t count = lanes_left(x, panorama.width);
        if (count < lane_count)
            memcpy(last, texels + x, count * sizeof(int32_t));
        const vec3 c = unpack_texel(hn::LoadU(IntTag(), count < lane_count ? last : texels + x));
        sums[0] += c;
        for (size_t i = 0; i < 4; ++i)
            sums[i + 1] += Real(hn::LoadU(FloatTag(), orders.rows[i].data() + x)) * c;
    }
    std::array<std::array<double, 5>, 3> moments{};
    const auto total = [&](Real r) HWY_ATTR {
        return static_cast<double>(panorama.scale) *
               static_cast<double>(hn::GetLane(hn::SumOfLanes(FloatTag(), r.v)));
    };
    for (size_t i = 0; i < 5; ++i) {
        moments[0][i] = total(sums[i].x);
        moments[1][i] = total(sums[i].y);
        moments[2][i] = total(sums[i].z);
    }
    return moments;
}

HWY_FLATTEN void resample_row(const ResampleRow& row, CubeChain& chain)
{
    const Panorama& p = *row.panorama;
    const PanoramaView picture{reinterpret_cast<const int32_t*>(p.texels.data()), p.width, p.height,
                               row.limit / p.scale};
    const int size = chain.face_size(0);
    const Real scale = p.scale / chain.scale;
    uint16_t* out = chain.halfs() + 3 * chain.texel(0, row.face, 0, row.y);
    for (int x = row.first; x < row.end; x += static_cast<int>(lane_count)) {
        vec3 sum(0.0);
        Real solid_angles = 0.0; // relative to each other
        for (const TexelPoint& point : *row.points) {
            const Real t = (static_cast<float>(row.y) + point.y) * 2.0f / static_cast<float>(size) - 1.0f;
            const vec3 d = direction_from_cube(row.face, face_coordinate(x, point.x, size), t);
            const Real inverse = inversesqrt(dot(d, d)), solid_angle = inverse * inverse * inverse;
            sum += solid_angle * panorama_bilinear(picture, equirectangular_from_direction(inverse * d));
            solid_angles += solid_angle;
        }
        store_halfs(scale / solid_angles * sum, lanes_left(x, row.end), out + 3 * x);
    }
}

HWY_FLATTEN void blur_row(const BlurRow& row, CubeChain& chain)
{
    const CubeView source = view(chain);
    const int size = chain.face_size(row.level);
    const Int source_level = integer(row.level - 1);
    const GaussianTaps& taps = *row.taps;
    const Real weight = 1.0f / static_cast<float>(taps.x.size());
    const Real t = (static_cast<float>(row.y) + 0.5f) * 2.0f / static_cast<float>(size) - 1.0f;
    uint16_t* out = chain.halfs() + 3 * chain.texel(row.level, row.face, 0, row.y);
    for (int x = 0; x < size; x += static_cast<int>(lane_count)) {
        const vec3 d = normalize(direction_from_cube(row.face, face_coordinate(x, 0.5f, size), t));
        const mat3 frame = frame_on_face(row.face, d);
        LevelSums sums(source, source_level);
        for (size_t i = 0; i < taps.x.size(); ++i)
            sums.add(frame * vec3(taps.x[i], taps.y[i], taps.z[i]));
        store_halfs(weight * sums.sum(), lanes_left(x, size), out + 3 * x);
    }
}

HWY_FLATTEN void irradiance_row(const LightCells& cells, int face, int y, CubeChain& map)
{
    const int size = map.face_size(0);
    const Real t = (static_cast<float>(y) + 0.5f) * 2.0f / static_cast<float>(size) - 1.0f;
    uint16_t* out = map.halfs() + 3 * map.texel(0, face, 0, y);
    for (int x = 0; x < size; x += static_cast<int>(lane_count)) {
        const vec3 n = normalize(direction_from_cube(face, face_coordinate(x, 0.5f, size), t));
        Real sums[3] = {0.0, 0.0, 0.0};
        for (size_t i = 0; i < cells.x[0].size(); ++i)
            for (int c = 0; c < 3; ++c)
                sums[c] += max(dot(n, vec3(cells.x[c][i], cells.y[c][i], cells.z[c][i])), 0.0);
        store_halfs(Real(1.0f / map.scale) * vec3(sums[0], sums[1], sums[2]), lanes_left(x, size),
                    out + 3 * x);
    }
}

} // namespace lambent::environment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::environment {

HWY_EXPORT(pack_row);
HWY_EXPORT(row_moments);
HWY_EXPORT(resample_row);
HWY_EXPORT(blur_row);
HWY_EXPORT(irradiance_row);

void pack_row(const float* rgb, int count, float factor, std::uint32_t* texels)
{
    HWY_DYNAMIC_DISPATCH(pack_row)(rgb, count, factor, texels);
}

std::array<std::array<double, 5>, 3> row_moments(const Panorama& panorama, int y, const AzimuthOrders& orders)
{
    return HWY_DYNAMIC_DISPATCH(row_moments)(panorama, y, orders);
}

void resample_row(const ResampleRow& row, CubeChain& chain)
{
    HWY_DYNAMIC_DISPATCH(resample_row)(row, chain);
}

void blur_row(const BlurRow& row, CubeChain& chain)
{
    HWY_DYNAMIC_DISPATCH(blur_row)(row, chain);
}

void irradiance_row(const LightCells& cells, int face, int y, CubeChain& map)
{
    HWY_DYNAMIC_DISPATCH(irradiance_row)(cells, face, y, map);
}

} // namespace lambent::environment
#endif
