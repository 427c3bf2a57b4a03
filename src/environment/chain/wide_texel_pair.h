// Two neighbouring texels of a CubeChain in the vectors of each target. Included by wide_cube.h: no guard.

// A TexelPair holds two texels side by side, or a sum of such pairs: lanes r g b r g b, and two lanes without meaning.

#if HWY_MAX_BYTES >= 32
using PairTag = hn::FixedTag<float, 8>;
using PairHalfTag = hn::FixedTag<hwy::float16_t, 8>;

struct TexelPair {
    hn::Vec<PairTag> v;
};

HWY_INLINE TexelPair load_pair(const uint16_t* halfs)
{
    return {
        hn::PromoteTo(PairTag(), hn::LoadU(PairHalfTag(), reinterpret_cast<const hwy::float16_t*>(halfs)))};
}

HWY_INLINE TexelPair load_pair(const float* eight)
{
    return {hn::Load(PairTag(), eight)};
}

HWY_INLINE void store_pair(TexelPair a, float* eight)
{
    hn::Store(a.v, PairTag(), eight);
}

// a + f (b - a)
HWY_INLINE TexelPair mix(TexelPair a, TexelPair b, float f)
{
    return {hn::MulAdd(hn::Sub(b.v, a.v), hn::Set(PairTag(), f), a.v)};
}

// The left texel times 1 - f, the right one times f.
HWY_INLINE TexelPair weight_texels(TexelPair a, float f)
{
    alignas(32) static constexpr float at_zero[8] = {1, 1, 1, 0, 0, 0, 0, 0};
    alignas(32) static constexpr float rise[8] = {-1, -1, -1, 1, 1, 1, 0, 0};
    const PairTag d;
    return {hn::Mul(a.v, hn::MulAdd(hn::Load(d, rise), hn::Set(d, f), hn::Load(d, at_zero)))};
}

HWY_INLINE TexelPair add_weighted(TexelPair sum, TexelPair a, float weight)
{
    return {hn::MulAdd(a.v, hn::Set(PairTag(), weight), sum.v)};
}
#elif HWY_TARGET != HWY_SCALAR
using QuadTag = hn::FixedTag<float, 4>;

// Lanes r g b r, and g b with two lanes without meaning.
struct TexelPair {
    hn::Vec<QuadTag> low, high;
};

// Converts four halfs that are not negative: shifted to a float's exponent and mantissa they are too small by a factor
// of 2^112, and multiplying by it is exact for subnormals too.
HWY_INLINE hn::Vec<QuadTag> load_quad(const uint16_t* halfs)
{
    const hn::FixedTag<uint16_t, 4> d16;
    const hn::FixedTag<uint32_t, 4> d32;
    const auto moved = hn::ShiftLeft<13>(hn::PromoteTo(d32, hn::LoadU(d16, halfs)));
    return hn::Mul(hn::BitCast(QuadTag(), moved), hn::Set(QuadTag(), 0x1p112f));
}

HWY_INLINE TexelPair load_pair(const uint16_t* halfs)
{
    return {load_quad(halfs), load_quad(halfs + 4)};
}

HWY_INLINE TexelPair load_pair(const float* eight)
{
    return {hn::Load(QuadTag(), eight), hn::Load(QuadTag(), eight + 4)};
}

HWY_INLINE void store_pair(TexelPair a, float* eight)
{
    hn::Store(a.low, QuadTag(), eight);
    hn::Store(a.high, QuadTag(), eight + 4);
}

HWY_INLINE TexelPair mix(TexelPair a, TexelPair b, float f)
{
    const auto fraction = hn::Set(QuadTag(), f);
    return {hn::MulAdd(hn::Sub(b.low, a.low), fraction, a.low),
            hn::MulAdd(hn::Sub(b.high, a.high), fraction, a.high)};
}

HWY_INLINE TexelPair weight_texels(TexelPair a, float f)
{
    alignas(16) static constexpr float at_zero[4] = {1, 1, 1, 0}, rise[4] = {-1, -1, -1, 1};
    const QuadTag d;
    const auto fraction = hn::Set(d, f);
    return {hn::Mul(a.low, hn::MulAdd(hn::Load(d, rise), fraction, hn::Load(d, at_zero))),
            hn::Mul(a.high, fraction)};
}

HWY_INLINE TexelPair add_weighted(TexelPair sum, TexelPair a, float weight)
{
    const auto w = hn::Set(QuadTag(), weight);
    return {hn::MulAdd(a.low, w, sum.low), hn::MulAdd(a.high, w, sum.high)};
}
#else
struct TexelPair {
    float v[8];
};

HWY_INLINE TexelPair load_pair(const uint16_t* halfs)
{
    TexelPair pair;
    for (int i = 0; i < 8; ++i) {
        const uint32_t moved = static_cast<uint32_t>(halfs[i]) << 13;
        memcpy(&pair.v[i], &moved, sizeof moved);
        pair.v[i] *= 0x1p112f;
    }
    return pair;
}

HWY_INLINE TexelPair load_pair(const float* eight)
{
    TexelPair pair;
    memcpy(pair.v, eight, sizeof pair.v);
    return pair;
}

HWY_INLINE void store_pair(TexelPair a, float* eight)
{
    memcpy(eight, a.v, sizeof a.v);
}

HWY_INLINE TexelPair mix(TexelPair a, TexelPair b, float f)
{
    for (int i = 0; i < 8; ++i)
        a.v[i] += f * (b.v[i] - a.v[i]);
    return a;
}

HWY_INLINE TexelPair weight_texels(TexelPair a, float f)
{
    for (int i = 0; i < 8; ++i)
        a.v[i] *= i < 3 ? 1.0f - f : f;
    return a;
}

HWY_INLINE TexelPair add_weighted(TexelPair sum, TexelPair a, float weight)
{
    for (int i = 0; i < 8; ++i)
        sum.v[i] += weight * a.v[i];
    return sum;
}
#endif
