#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/specular/yardstick_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "bench/specular/yardstick.h"

HWY_BEFORE_NAMESPACE();
namespace lambent::bench::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::ScalableTag<float>;
using IntTag = hn::RebindToSigned<FloatTag>;
using Float = hn::Vec<FloatTag>;
using Int = hn::Vec<IntTag>;

HWY_INLINE Float all(float a)
{
    return hn::Set(FloatTag(), a);
}
HWY_INLINE Int all_int(int a)
{
    return hn::Set(IntTag(), a);
}
HWY_INLINE Float mad(Float a, Float b, Float c)
{
    return hn::MulAdd(a, b, c);
}
HWY_INLINE Float to_float(Int a)
{
    return hn::ConvertTo(FloatTag(), a);
}
HWY_INLINE Int to_int(Float a)
{
    return hn::ConvertTo(IntTag(), a);
}
HWY_INLINE Float as_float(Int a)
{
    return hn::BitCast(FloatTag(), a);
}
HWY_INLINE Int as_int(Float a)
{
    return hn::BitCast(IntTag(), a);
}

HWY_INLINE Float reciprocal(Float a)
{
    const Float r = hn::ApproximateReciprocal(a);
    return hn::Mul(r, hn::NegMulAdd(a, r, all(2)));
}

HWY_INLINE Float inverse_root(Float a)
{
    const Float r = hn::ApproximateReciprocalSqrt(a);
    return hn::Mul(r, hn::NegMulAdd(hn::Mul(hn::Mul(all(0.5f), a), r), r, all(1.5f)));
}

template <class... Rest>
HWY_INLINE Float polynomial(Float t, float first, Rest... rest)
{
    Float p = all(first);
    ((p = mad(p, t, all(rest))), ...);
    return p;
}

HWY_INLINE Float log2(Float x)
{
    const Int exponent = hn::Sub(hn::ShiftRight<23>(as_int(x)), all_int(127));
    const Int mantissa = hn::Or(hn::And(as_int(x), all_int(0x7fffff)), all_int(0x3f800000));
    const Float t = hn::Sub(as_float(mantissa), all(1));
    const Float p = polynomial(t, 0.020974999f, -0.0975204977f, 0.217224967f, -0.340096566f, 0.477904954f,
                               -0.721179805f, 1.44269349f);
    return mad(p, t, to_float(exponent));
}

HWY_INLINE Float exp2(Float x)
{
    const Float n = hn::Round(x);
    const Float p = polynomial(hn::Sub(x, n), 0.00132764584f, 0.00967554173f, 0.0555071332f, 0.240221197f,
                               0.693146967f, 1.00000007f);
    return as_float(hn::Add(as_int(p), hn::ShiftLeft<23>(to_int(n))));
}

struct Vec3 {
    Float x, y, z;
};

HWY_INLINE Vec3 splat(const float* p)
{
    return {all(p[0]), all(p[1]), all(p[2])};
}
HWY_INLINE Float dot(const Vec3& a, const Vec3& b)
{
    return mad(a.x, b.x, mad(a.y, b.y, hn::Mul(a.z, b.z)));
}
HWY_INLINE Vec3 mad(const Vec3& a, Float s, const Vec3& b)
{
    return {mad(a.x, s, b.x), mad(a.y, s, b.y), mad(a.z, s, b.z)};
}
HWY_INLINE Vec3 mul(const Vec3& a, Float s)
{
    return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}

// Adds the light of packed texels, weighed. The exponent becomes a float's; the bias of 15 and 9 bits of mantissa go in.
HWY_INLINE void add_texel(const int32_t* texels, Int index, Float weight, Vec3& sum)
{
    const Int texel = hn::GatherIndex(IntTag(), texels, index);
    const auto field =
        hn::BitCast(hn::RebindToUnsigned<IntTag>(), hn::And(texel, all_int(static_cast<int>(0xF8000000))));
    const Int exponent = hn::Add(hn::BitCast(IntTag(), hn::ShiftRight<4>(field)), all_int(103 << 23));
    const Float scale = hn::Mul(as_float(exponent), weight);
    const Int mask = all_int(511);
    sum.x = mad(to_float(hn::And(texel, mask)), scale, sum.x);
    sum.y = mad(to_float(hn::And(hn::ShiftRight<9>(texel), mask)), scale, sum.y);
    sum.z = mad(to_float(hn::And(hn::ShiftRight<18>(texel), mask)), scale, sum.z);
}

struct Face {
    Float s, t;
    Int index;
};

HWY_INLINE Face face_of(const Vec3& d)
{
    const Float ax = hn::Abs(d.x), ay = hn::Abs(d.y), az = hn::Abs(d.z);
    const auto x_major = hn::And(hn::Ge(ax, ay), hn::Ge(ax, az));
    const auto y_major = hn::AndNot(x_major, hn::Ge(ay, az));
    const Float scale =
        hn::Mul(all(0.5f), reciprocal(hn::IfThenElse(x_major, ax, hn::IfThenElse(y_major, ay, az))));
    const Float zero = all(0);
    const Float s =
        hn::IfThenElse(x_major, hn::IfThenElse(hn::Lt(d.x, zero), d.z, hn::Neg(d.z)),
                       hn::IfThenElse(y_major, d.x, hn::IfThenElse(hn::Lt(d.z, zero), hn::Neg(d.x), d.x)));
    const Float t =
        hn::IfThenElse(y_major, hn::IfThenElse(hn::Lt(d.y, zero), hn::Neg(d.z), d.z), hn::Neg(d.y));
    const Int sx = hn::BroadcastSignBit(as_int(d.x)), sy = hn::BroadcastSignBit(as_int(d.y));
    const Int sz = hn::BroadcastSignBit(as_int(d.z));
    const Int index = hn::IfThenElse(
        hn::RebindMask(IntTag(), x_major), hn::Sub(all_int(0), sx),
        hn::IfThenElse(hn::RebindMask(IntTag(), y_major), hn::Sub(all_int(2), sy), hn::Sub(all_int(4), sz)));
    return {mad(s, scale, all(0.5f)), mad(t, scale, all(0.5f)), index};
}

HWY_INLINE void add_level(const YardstickCube& cube, const Face& face, Int level, Float weight, Vec3& sum)
{
    const Int size = hn::Shr(all_int(1 << cube.log2_size), level), pitch = hn::Add(size, all_int(2));
    const Float x = mad(face.s, to_float(size), all(0.5f)), y = mad(face.t, to_float(size), all(0.5f));
    const Float x0 = hn::Floor(x), y0 = hn::Floor(y);
    const Int start = hn::Shr(all_int(24 << (2 * cube.log2_size)), hn::Add(level, level));
    const Int row = hn::Add(hn::Mul(face.index, pitch), to_int(y0));
    const Int index = hn::Add(start, hn::Add(hn::Mul(row, pitch), to_int(x0)));
    const Float fx = hn::Sub(x, x0), below = hn::Mul(weight, hn::Sub(y, y0)), above = hn::Sub(weight, below);
    const Float upper_right = hn::Mul(above, fx), lower_right = hn::Mul(below, fx);
    const int32_t* texels = cube.texels.data();
    add_texel(texels, index, hn::Sub(above, upper_right), sum);
    add_texel(texels + 1, index, upper_right, sum);
    add_texel(texels, hn::Add(index, pitch), hn::Sub(below, lower_right), sum);
    add_texel(texels + 1, hn::Add(index, pitch), lower_right, sum);
}

HWY_INLINE Vec3 fetch(const YardstickCube& cube, const Vec3& d, Float level)
{
    const Float fine = hn::Floor(level), fraction = hn::Sub(level, fine);
    const Int first = to_int(fine), second = hn::Min(hn::Add(first, all_int(1)), all_int(cube.log2_size));
    const Face face = face_of(d);
    Vec3 sum{all(0), all(0), all(0)};
    add_level(cube, face, first, hn::Sub(all(1), fraction), sum);
    add_level(cube, face, second, fraction, sum);
    return sum;
}

struct Surface {
    hn::Mask<FloatTag> seen;
    Vec3 normal, albedo, specular;
    Float exponent;
};

HWY_INLINE Vec3 choose(hn::Mask<FloatTag> m, const Vec3& a, const Vec3& b)
{
    return {hn::IfThenElse(m, a.x, b.x), hn::IfThenElse(m, a.y, b.y), hn::IfThenElse(m, a.z, b.z)};
}

// A unit sphere of gold on a floor at y = -1.
HWY_INLINE Surface meet(const Vec3& origin, const Vec3& d)
{
    const Float b = dot(origin, d), c = hn::Sub(dot(origin, origin), all(1));
    const Float discriminant = hn::Sub(hn::Mul(b, b), c);
    const auto sphere = hn::Gt(discriminant, all(0));
    Vec3 n = mad(d, hn::Sub(hn::Neg(b), hn::Sqrt(hn::Max(discriminant, all(0)))), origin);
    n = mul(n, inverse_root(dot(n, n)));
    const Float floor_distance = hn::Div(hn::Sub(all(-1), origin.y), hn::Min(d.y, all(-1e-6f)));
    const auto floor = hn::And(hn::Lt(d.y, all(0)), hn::Lt(floor_distance, all(40)));
    const Vec3 normal = choose(sphere, n, {all(0), all(1), all(0)});
    return {hn::Or(sphere, floor), normal,
            choose(sphere, {all(0), all(0), all(0)}, {all(0.5f), all(0.4f), all(0.3f)}),
            choose(sphere, {all(1), all(0.77f), all(0.34f)}, {all(0.04f), all(0.04f), all(0.04f)}),
            hn::IfThenElse(sphere, exp2(mad(all(4), normal.y, all(6))), all(64))};
}

// The report's specular pass, its sums split in the two parts of Schlick's reflectance.
HWY_INLINE Vec3 specular(const YardstickScene& scene, const Surface& s, const Vec3& V)
{
    const Vec3& N = s.normal;
    const Float NV = dot(N, V);
    const Vec3 R = mad(N, hn::Add(NV, NV), {hn::Neg(V.x), hn::Neg(V.y), hn::Neg(V.z)});
    const Float sign = hn::CopySign(all(1), R.z), a = hn::Neg(reciprocal(hn::Add(sign, R.z)));
    const Float b = hn::Mul(hn::Mul(R.x, R.y), a), sx = hn::Mul(sign, R.x);
    const Vec3 T{mad(hn::Mul(sx, R.x), a, all(1)), hn::Mul(sign, b), hn::Neg(sx)};
    const Vec3 B{b, mad(hn::Mul(R.y, R.y), a, sign), hn::Neg(R.y)};
    const Float inverse_exponent = reciprocal(hn::Add(s.exponent, all(1)));
    const Float peak = hn::Mul(all(-0.5f), log2(hn::Mul(hn::Add(s.exponent, all(2)), all(0.0397887358f))));
    const Float level_at_peak = hn::Add(all(scene.base_level), peak),
                per_log = hn::Mul(all(-0.5f), s.exponent);
    Vec3 plain{all(0), all(0), all(0)}, grazing = plain;
    for (const auto& point : scene.points) {
        const Float cosine = exp2(hn::Mul(inverse_exponent, all(point[2])));
        const Float sine = hn::Sqrt(hn::Max(hn::NegMulAdd(cosine, cosine, all(1)), all(0)));
        const Vec3 L =
            mad(T, hn::Mul(sine, all(point[0])), mad(B, hn::Mul(sine, all(point[1])), mul(R, cosine)));
        const Float NL = dot(N, L), HH = hn::Max(mad(dot(L, V), all(2), all(2)), all(2e-6f));
        const Float h = inverse_root(HH), NH = hn::Max(hn::Mul(hn::Add(NL, NV), h), all(1e-4f));
        const Float level = hn::Min(hn::Max(mad(per_log, log2(NH), level_at_peak), all(0)),
                                    all(static_cast<float>(scene.environment.log2_size)));
        const Vec3 light = fetch(scene.environment, L, level);
        const Float m = hn::NegMulAdd(hn::Mul(all(0.5f), HH), h, all(1)), m2 = hn::Mul(m, m);
        const Float weight = hn::Mul(hn::Max(NL, all(0)), reciprocal(HH));
        const Float grazing_weight = hn::Mul(weight, hn::Mul(hn::Mul(m2, m2), m));
        plain = mad(light, hn::Sub(weight, grazing_weight), plain);
        grazing = mad(light, grazing_weight, grazing);
    }
    const Float share = all(1.0f / yardstick_samples);
    return {hn::Mul(mad(s.specular.x, plain.x, grazing.x), share),
            hn::Mul(mad(s.specular.y, plain.y, grazing.y), share),
            hn::Mul(mad(s.specular.z, plain.z, grazing.z), share)};
}

} // namespace

HWY_FLATTEN void draw_row(const YardstickScene& scene, int y, float* rgba)
{
    const FloatTag d;
    const Float down = all(1 - (static_cast<float>(y) + 0.5f) * (2.0f / yardstick_height));
    for (int x = 0; x < yardstick_width; x += static_cast<int>(hn::Lanes(d))) {
        const Float across =
            mad(hn::Iota(d, static_cast<float>(x) + 0.5f), all(2.0f / yardstick_width), all(-1));
        Vec3 ray = mad(splat(scene.right), across, mad(splat(scene.up), down, splat(scene.forward)));
        ray = mul(ray, inverse_root(dot(ray, ray)));
        const Surface s = meet(splat(scene.eye), ray);
        Vec3 color{all(0), all(0), all(0)};
        if (!hn::AllFalse(d, s.seen)) {
            const Vec3 shine = specular(scene, s, {hn::Neg(ray.x), hn::Neg(ray.y), hn::Neg(ray.z)});
            const Vec3 diffuse = fetch(scene.irradiance, s.normal, all(0));
            color = choose(s.seen,
                           {mad(s.albedo.x, diffuse.x, shine.x), mad(s.albedo.y, diffuse.y, shine.y),
                            mad(s.albedo.z, diffuse.z, shine.z)},
                           color);
        }
        hn::StoreInterleaved4(color.x, color.y, color.z, all(1), d, rgba + 4 * x);
    }
}

} // namespace lambent::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent::bench {

HWY_EXPORT(draw_row);

void draw_yardstick_row(const YardstickScene& scene, int y, float* rgba)
{
    HWY_DYNAMIC_DISPATCH(draw_row)(scene, y, rgba);
}

} // namespace lambent::bench
#endif
