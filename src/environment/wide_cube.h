// Looking up a CubeChain with lanes of directions. Included after wide/wide.h, inside the target's namespace: no guard.
//
// No gather: on most processors a gather costs one load a lane anyway, and reads one texel with it. Here each lane
// loads two neighbouring texels at once (six halfs of eight) and weighs them as one vector; the lanes' results are
// turned back into lanes at the end. 0.6 to 0.8 of the time of gathers of packed texels (bench/specular_pass).

// What the lookups need of a CubeChain, without std::.
struct CubeView {
    const uint16_t* halfs;
    int log2_size;
    int levels;
};

// Face index, and position on the face in [0, 1]. [Vulkan 1.3, "Cube Map Face Selection"]
struct FacePoint {
    Real s, t;
    Int face;
};

HWY_INLINE FacePoint face_point(vec3 d)
{
    const Real ax = abs(d.x), ay = abs(d.y), az = abs(d.z);
    const Mask x_major = ax >= ay && ax >= az;
    const Mask y_major = !x_major && ay >= az;
    const Real major = select(x_major, ax, select(y_major, ay, az));
    const Real scale = 0.5 * reciprocal(max(major, 1.0e-30));
    const Real s =
        select(x_major, select(d.x < 0.0, d.z, -d.z), select(y_major, d.x, select(d.z < 0.0, -d.x, d.x)));
    const Real t = select(y_major, select(d.y < 0.0, -d.z, d.z), -d.y);
    const Real axis = select(x_major, d.x, select(y_major, d.y, d.z));
    const Int pair =
        hn::IfThenElse(hn::RebindMask(IntTag(), x_major.m), integer(0),
                       hn::IfThenElse(hn::RebindMask(IntTag(), y_major.m), integer(2), integer(4)));
    // The sign bit, shifted over the whole lane, is -1 for the negative face of the pair.
    return {s * scale + 0.5, t * scale + 0.5, hn::Sub(pair, hn::BroadcastSignBit(bits(axis)))};
}

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

// The weights (w00 w01 w10 w11) of a bilinear filter, spread over the texels of its upper and lower pair.
struct PairWeights {
    hn::Vec<PairTag> upper, lower;
};

HWY_INLINE PairWeights load_weights(const float* four)
{
    alignas(32) static constexpr int32_t upper[8] = {0, 0, 0, 1, 1, 1, 1, 1};
    alignas(32) static constexpr int32_t lower[8] = {2, 2, 2, 3, 3, 3, 3, 3};
    const auto w = hn::LoadDup128(PairTag(), four);
    return {hn::TableLookupLanes(w, hn::SetTableIndices(PairTag(), upper)),
            hn::TableLookupLanes(w, hn::SetTableIndices(PairTag(), lower))};
}

HWY_INLINE TexelPair filtered(TexelPair upper, TexelPair lower, PairWeights w)
{
    return {hn::MulAdd(lower.v, w.lower, hn::Mul(upper.v, w.upper))};
}

HWY_INLINE TexelPair operator+(TexelPair a, TexelPair b)
{
    return {hn::Add(a.v, b.v)};
}

// Left and right texel added, to four floats of which the first three are RGB.
HWY_INLINE void store_folded(TexelPair a, float* four)
{
    alignas(32) static constexpr int32_t right[8] = {3, 4, 5, 6, 0, 0, 0, 0};
    const hn::FixedTag<float, 4> d4;
    const auto moved = hn::TableLookupLanes(a.v, hn::SetTableIndices(PairTag(), right));
    hn::Store(hn::Add(hn::LowerHalf(d4, a.v), hn::LowerHalf(d4, moved)), d4, four);
}
#else
struct TexelPair {
    float v[8];
};

HWY_INLINE TexelPair load_pair(const uint16_t* halfs)
{
    // A half that is not negative, moved to a float's mantissa and exponent, is short of 2^112: exact for subnormals too.
    TexelPair pair;
    for (int i = 0; i < 8; ++i) {
        const uint32_t moved = static_cast<uint32_t>(halfs[i]) << 13;
        memcpy(&pair.v[i], &moved, sizeof moved);
        pair.v[i] *= 0x1p112f;
    }
    return pair;
}

struct PairWeights {
    const float* four;
};

HWY_INLINE PairWeights load_weights(const float* four)
{
    return {four};
}

HWY_INLINE TexelPair filtered(TexelPair upper, TexelPair lower, PairWeights w)
{
    TexelPair sum;
    for (int i = 0; i < 8; ++i)
        sum.v[i] = upper.v[i] * w.four[i < 3 ? 0 : 1] + lower.v[i] * w.four[i < 3 ? 2 : 3];
    return sum;
}

HWY_INLINE TexelPair operator+(TexelPair a, TexelPair b)
{
    for (int i = 0; i < 8; ++i)
        a.v[i] += b.v[i];
    return a;
}

HWY_INLINE void store_folded(TexelPair a, float* four)
{
    for (int i = 0; i < 4; ++i)
        four[i] = a.v[i] + a.v[i + 3];
}
#endif

// Where the lanes' four texels are at one level, in halfs from the start, and how much each weighs.
struct LevelTaps {
    alignas(64) int32_t upper[max_lanes];
    alignas(64) int32_t lower[max_lanes];
    alignas(64) float weights[4 * max_lanes];
};

// The faces at a level: size in texels and first texel.
struct LevelShape {
    Int size, start;
};

HWY_INLINE LevelShape level_shape(CubeView cube, Int level)
{
    const Int size = hn::Shr(integer(1 << cube.log2_size), level);
    const Int two_squares = hn::Shr(integer(2 << (2 * cube.log2_size)), hn::Add(level, level));
    const Int log2_n = hn::Sub(integer(cube.log2_size), level);
    const Int twenty_four = hn::Mul(integer(24), hn::Add(size, log2_n));
    return {size, hn::Add(two_squares, hn::Sub(twenty_four, integer(26)))};
}

HWY_INLINE void place_taps(LevelShape shape, FacePoint p, Real weight, LevelTaps& taps)
{
    const Real size = to_real(shape.size);
    const Real x = p.s * size + 0.5, y = p.t * size + 0.5; // + 0.5: half a texel back, one for the border
    const Real x0 = floor(x), y0 = floor(y);
    const Int pitch = hn::Add(shape.size, integer(2));
    const Int row = hn::Add(hn::Mul(p.face, pitch), truncated(y0));
    const Int texel = hn::Add(shape.start, hn::Add(hn::Mul(row, pitch), truncated(x0)));
    const Int half = hn::Add(texel, hn::Add(texel, texel));
    hn::Store(half, IntTag(), taps.upper);
    hn::Store(hn::Add(half, hn::Add(pitch, hn::Add(pitch, pitch))), IntTag(), taps.lower);
    const Real right = x - x0, below = weight * (y - y0), above = weight - below;
    const Real w01 = above * right, w11 = below * right;
    hn::StoreInterleaved4((above - w01).v, w01.v, (below - w11).v, w11.v, FloatTag(), taps.weights);
}

HWY_INLINE TexelPair fetch(const uint16_t* halfs, const LevelTaps& taps, size_t lane)
{
    return filtered(load_pair(halfs + taps.upper[lane]), load_pair(halfs + taps.lower[lane]),
                    load_weights(taps.weights + 4 * lane));
}

HWY_INLINE vec3 load_rgbx(const float* four_per_lane)
{
    Real r(0.0), g(0.0), b(0.0), unused(0.0);
    hn::LoadInterleaved4(FloatTag(), four_per_lane, r.v, g.v, b.v, unused.v);
    return {r, g, b};
}

// Half-float RGB (radiance over the chain's scale) from direction d, any length, at a whole level.
HWY_INLINE vec3 cube_bilinear(CubeView cube, vec3 d, Int level)
{
    LevelTaps taps;
    place_taps(level_shape(cube, level), face_point(d), 1.0, taps);
    alignas(64) float rgbx[4 * max_lanes];
    for (size_t lane = 0; lane < lane_count; ++lane)
        store_folded(fetch(cube.halfs, taps, lane), rgbx + 4 * lane);
    return load_rgbx(rgbx);
}

// The same between two levels, as GLSL's textureLod; level is clamped to the chain.
HWY_INLINE vec3 cube_trilinear(CubeView cube, vec3 d, Real level)
{
    const FacePoint p = face_point(d);
    const Real clamped = min(level, cube.levels - 1);
    const Real fine = min(floor(clamped), cube.levels - 2);
    const Real fraction = clamped - fine;
    const Int fine_level = truncated(fine);
    LevelTaps taps[2];
    place_taps(level_shape(cube, fine_level), p, 1.0 - fraction, taps[0]);
    place_taps(level_shape(cube, hn::Add(fine_level, integer(1))), p, fraction, taps[1]);
    alignas(64) float rgbx[4 * max_lanes];
    for (size_t lane = 0; lane < lane_count; ++lane)
        store_folded(fetch(cube.halfs, taps[0], lane) + fetch(cube.halfs, taps[1], lane), rgbx + 4 * lane);
    return load_rgbx(rgbx);
}
