// Looking up a CubeChain with lanes of directions. Included after wide/wide.h, inside the target's namespace: no guard.
//
// No gather: on most processors a gather costs one load a lane anyway, and reads one texel with it. Here the lanes'
// addresses and fractions are written to a queue of a few samples; then each lane goes through its samples, loads two
// neighbouring texels at a time (six halfs of eight), filters them as one vector and keeps its sums in registers.
// 0.7 of the time of gathers of packed texels (bench/specular).

// What the lookups need of a CubeChain, without std::.
struct CubeView {
    const uint16_t* halfs;
    int log2_size;
    int levels;
};

// Two texels side by side, or sums of such: r g b r g b and two lanes of rubbish.
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
HWY_INLINE TexelPair between(TexelPair a, TexelPair b, float f)
{
    return {hn::MulAdd(hn::Sub(b.v, a.v), hn::Set(PairTag(), f), a.v)};
}

// The left texel times 1 - f, the right one times f.
HWY_INLINE TexelPair shared(TexelPair a, float f)
{
    alignas(32) static constexpr float at_0[8] = {1, 1, 1, 0, 0, 0, 0, 0};
    alignas(32) static constexpr float rise[8] = {-1, -1, -1, 1, 1, 1, 0, 0};
    const PairTag d;
    return {hn::Mul(a.v, hn::MulAdd(hn::Load(d, rise), hn::Set(d, f), hn::Load(d, at_0)))};
}

HWY_INLINE TexelPair plus(TexelPair sum, TexelPair a, float weight)
{
    return {hn::MulAdd(a.v, hn::Set(PairTag(), weight), sum.v)};
}
#elif HWY_TARGET != HWY_SCALAR
using QuadTag = hn::FixedTag<float, 4>;

// Lanes r g b r and g b and two of rubbish.
struct TexelPair {
    hn::Vec<QuadTag> low, high;
};

// Four halfs that are not negative: moved to a float's mantissa and exponent they are short of 2^112, which is exact
// for subnormals too.
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

HWY_INLINE TexelPair between(TexelPair a, TexelPair b, float f)
{
    const auto fraction = hn::Set(QuadTag(), f);
    return {hn::MulAdd(hn::Sub(b.low, a.low), fraction, a.low),
            hn::MulAdd(hn::Sub(b.high, a.high), fraction, a.high)};
}

HWY_INLINE TexelPair shared(TexelPair a, float f)
{
    alignas(16) static constexpr float at_0[4] = {1, 1, 1, 0}, rise[4] = {-1, -1, -1, 1};
    const QuadTag d;
    const auto fraction = hn::Set(d, f);
    return {hn::Mul(a.low, hn::MulAdd(hn::Load(d, rise), fraction, hn::Load(d, at_0))),
            hn::Mul(a.high, fraction)};
}

HWY_INLINE TexelPair plus(TexelPair sum, TexelPair a, float weight)
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

HWY_INLINE TexelPair between(TexelPair a, TexelPair b, float f)
{
    for (int i = 0; i < 8; ++i)
        a.v[i] += f * (b.v[i] - a.v[i]);
    return a;
}

HWY_INLINE TexelPair shared(TexelPair a, float f)
{
    for (int i = 0; i < 8; ++i)
        a.v[i] *= i < 3 ? 1.0f - f : f;
    return a;
}

HWY_INLINE TexelPair plus(TexelPair sum, TexelPair a, float weight)
{
    for (int i = 0; i < 8; ++i)
        sum.v[i] += weight * a.v[i];
    return sum;
}
#endif

// The lanes' texels at one level: where the upper and the lower pair start, in halfs, and the fractions between them.
struct LevelTaps {
    alignas(64) int32_t upper[max_lanes];
    alignas(64) int32_t lower[max_lanes];
    alignas(64) float right[max_lanes];
    alignas(64) float below[max_lanes];
};

// A level as the addresses need it. The chain's layout: CubeChain::texel.
struct LevelShape {
    Real half_size;    // of a face, in texels
    Int start, pitch3; // texels to the first, halfs from row to row
};

HWY_INLINE LevelShape level_shape(CubeView cube, Int level)
{
    const Int exponent = hn::Sub(integer(126 + cube.log2_size), level);
    const Int start = hn::Shr(integer(8 << (2 * cube.log2_size)), hn::Add(level, level));
    const Int pitch3 = hn::Add(hn::Shr(integer(3 << cube.log2_size), level), integer(6));
    return {from_bits(hn::ShiftLeft<23>(exponent)), start, pitch3};
}

HWY_INLINE LevelShape next_level(LevelShape l)
{
    return {0.5 * l.half_size, hn::ShiftRight<2>(l.start), hn::Add(hn::ShiftRight<1>(l.pitch3), integer(3))};
}

HWY_INLINE void place_taps(LevelShape level, CubePlace p, LevelTaps& taps)
{
    // Texel centres lie half a texel in; the border adds one.
    const Real middle = level.half_size + 0.5;
    const Real x = p.s * level.half_size + middle, y = p.t * level.half_size + middle;
    const Real x0 = floor(x), y0 = floor(y);
    // Below 2^24 floats count exactly.
    const Real pitch = 2.0 * level.half_size + 2.0;
    const Int in_level = truncated((p.face * pitch + y0) * pitch + x0);
    const Int texel = hn::Add(level.start, in_level);
    const Int half = hn::Add(texel, hn::Add(texel, texel));
    hn::Store(half, IntTag(), taps.upper);
    hn::Store(hn::Add(half, level.pitch3), IntTag(), taps.lower);
    hn::Store((x - x0).v, FloatTag(), taps.right);
    hn::Store((y - y0).v, FloatTag(), taps.below);
}

HWY_INLINE TexelPair filtered(const uint16_t* halfs, const LevelTaps& taps, size_t lane)
{
    const TexelPair upper = load_pair(halfs + taps.upper[lane]), lower = load_pair(halfs + taps.lower[lane]);
    return shared(between(upper, lower, taps.below[lane]), taps.right[lane]);
}

HWY_INLINE vec3 load_rgbx(const float* four_per_lane)
{
    Real r(0.0), g(0.0), b(0.0), unused(0.0);
    hn::LoadInterleaved4(FloatTag(), four_per_lane, r.v, g.v, b.v, unused.v);
    return {r, g, b};
}

// Lanes of sums of pairs, as lanes of RGB: the two texels added up.
HWY_INLINE vec3 load_sums(const float (*eight)[8])
{
    alignas(64) float rgbx[4 * max_lanes];
    for (size_t lane = 0; lane < lane_count; ++lane)
        for (size_t c = 0; c < 4; ++c)
            rgbx[4 * lane + c] = eight[lane][c] + eight[lane][c + 3];
    return load_rgbx(rgbx);
}

// Samples of the chain between levels, added up with two weights each.
class CubeSums {
public:
    explicit HWY_INLINE CubeSums(CubeView cube) : cube_(cube) { clear(); }

    HWY_INLINE void clear() { memset(sums_, 0, sizeof sums_); }

    // From direction d, any length, as GLSL's textureLod; level is clamped to the chain.
    HWY_INLINE void add(vec3 d, Real level, Real first_weight, Real second_weight)
    {
        Sample& s = queue_[queued_];
        const Real clamped = min(level, cube_.levels - 1);
        const Real fine = min(floor(clamped), cube_.levels - 2);
        const CubePlace p = cube_from_direction(d);
        const LevelShape shape = level_shape(cube_, truncated(fine));
        place_taps(shape, p, s.fine);
        place_taps(next_level(shape), p, s.coarse);
        hn::Store((clamped - fine).v, FloatTag(), s.fraction);
        hn::Store(first_weight.v, FloatTag(), s.weight[0]);
        hn::Store(second_weight.v, FloatTag(), s.weight[1]);
        if (++queued_ == queue_length)
            flush();
    }

    // The sums, as halfs: radiance over the chain's scale.
    HWY_INLINE vec3 first() { return sum(0); }
    HWY_INLINE vec3 second() { return sum(1); }

private:
    static constexpr int queue_length = 4; // longer ones fall out of the innermost cache

    struct Sample {
        LevelTaps fine, coarse;
        alignas(64) float fraction[max_lanes];
        alignas(64) float weight[2][max_lanes];
    };

    HWY_INLINE void flush()
    {
        for (size_t lane = 0; lane < lane_count; ++lane) {
            TexelPair a = load_pair(sums_[0][lane]), b = load_pair(sums_[1][lane]);
            for (int i = 0; i < queued_; ++i) {
                const Sample& s = queue_[i];
                const TexelPair light = between(filtered(cube_.halfs, s.fine, lane),
                                                filtered(cube_.halfs, s.coarse, lane), s.fraction[lane]);
                a = plus(a, light, s.weight[0][lane]);
                b = plus(b, light, s.weight[1][lane]);
            }
            store_pair(a, sums_[0][lane]);
            store_pair(b, sums_[1][lane]);
        }
        queued_ = 0;
    }

    HWY_INLINE vec3 sum(int which)
    {
        if (queued_ > 0)
            flush();
        return load_sums(sums_[which]);
    }

    CubeView cube_;
    int queued_ = 0;
    Sample queue_[queue_length];
    alignas(64) float sums_[2][max_lanes][8];
};

// One sample, RGB over the chain's scale, between levels.
HWY_INLINE vec3 cube_trilinear(CubeView cube, vec3 d, Real level)
{
    CubeSums sums(cube);
    sums.add(d, level, 1.0, 0.0);
    return sums.first();
}

// Samples of one level, added up.
class LevelSums {
public:
    HWY_INLINE LevelSums(CubeView cube, Int level) : halfs_(cube.halfs), shape_(level_shape(cube, level))
    {
        memset(sums_, 0, sizeof sums_);
    }

    // From direction d, any length.
    HWY_INLINE void add(vec3 d)
    {
        place_taps(shape_, cube_from_direction(d), queue_[queued_]);
        if (++queued_ == queue_length)
            flush();
    }

    HWY_INLINE vec3 sum()
    {
        if (queued_ > 0)
            flush();
        return load_sums(sums_);
    }

private:
    static constexpr int queue_length = 8;

    HWY_INLINE void flush()
    {
        for (size_t lane = 0; lane < lane_count; ++lane) {
            TexelPair total = load_pair(sums_[lane]);
            for (int i = 0; i < queued_; ++i)
                total = plus(total, filtered(halfs_, queue_[i], lane), 1.0f);
            store_pair(total, sums_[lane]);
        }
        queued_ = 0;
    }

    const uint16_t* halfs_;
    LevelShape shape_;
    int queued_ = 0;
    LevelTaps queue_[queue_length];
    alignas(64) float sums_[max_lanes][8];
};

// One sample at a whole level.
HWY_INLINE vec3 cube_bilinear(CubeView cube, vec3 d, Int level)
{
    LevelSums sums(cube, level);
    sums.add(d);
    return sums.sum();
}
