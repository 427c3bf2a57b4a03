// Looking up a CubeChain with lanes of directions. Included after wide/wide.h, inside the target's namespace: no guard.
//
// No gather is used: on most processors it costs one load per lane, and each load reads only one texel. Here the lanes'
// addresses and fractions are written to a queue of a few samples; then each lane goes through its samples, loads two
// neighbouring texels at a time (six halfs of eight), filters them as one vector and keeps its sums in registers.
// This takes 0.7 of the time of gathers of packed texels (bench/specular).

#include "environment/chain/wide_texel_pair.h"
#include "environment/chain/wide_taps.h"

HWY_INLINE vec3 load_rgbx(const float* four_per_lane)
{
    Real r(0.0), g(0.0), b(0.0), unused(0.0);
    hn::LoadInterleaved4(FloatTag(), four_per_lane, r.v, g.v, b.v, unused.v);
    return {r, g, b};
}

// RGB of each lane from its sum of pairs: the two texels added.
HWY_INLINE vec3 load_sums(const float (*eight)[8])
{
    alignas(64) float rgbx[4 * max_lanes];
    for (size_t lane = 0; lane < lane_count; ++lane)
        for (size_t c = 0; c < 4; ++c)
            rgbx[4 * lane + c] = eight[lane][c] + eight[lane][c + 3];
    return load_rgbx(rgbx);
}

// Two sums of trilinear samples of the chain, each with weights of its own.
class CubeSums {
public:
    explicit HWY_INLINE CubeSums(CubeView cube) : cube_(cube) { clear(); }

    HWY_INLINE void clear() { memset(sums_, 0, sizeof sums_); }

    // Adds the sample in direction d, of any length, as GLSL's textureLod; level is clamped to the chain.
    HWY_INLINE void add(vec3 d, Real level, Real first_weight, Real second_weight)
    {
        Sample& s = queue_[queued_];
        const Real clamped = min(level, cube_.levels - 1);
        const Real fine = min(floor(clamped), cube_.levels - 2);
        const CubePlace p = cube_from_direction(d);
        const LevelShape shape = level_shape(cube_, truncated(fine));
        find_taps(shape, p, s.fine);
        find_taps(next_level(shape), p, s.coarse);
        hn::Store((clamped - fine).v, FloatTag(), s.fraction);
        hn::Store(first_weight.v, FloatTag(), s.weight[0]);
        hn::Store(second_weight.v, FloatTag(), s.weight[1]);
        if (++queued_ == queue_length)
            flush();
    }

    // The sums, of radiance over the chain's scale.
    HWY_INLINE vec3 first() { return sum(0); }
    HWY_INLINE vec3 second() { return sum(1); }

private:
    static constexpr int queue_length = 4; // longer queues do not fit the first-level cache

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
                const TexelPair light = mix(filtered(cube_.halfs, s.fine, lane),
                                            filtered(cube_.halfs, s.coarse, lane), s.fraction[lane]);
                a = add_weighted(a, light, s.weight[0][lane]);
                b = add_weighted(b, light, s.weight[1][lane]);
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

// One trilinear sample, RGB over the chain's scale.
HWY_INLINE vec3 cube_trilinear(CubeView cube, vec3 d, Real level)
{
    CubeSums sums(cube);
    sums.add(d, level, 1.0, 0.0);
    return sums.first();
}

// A sum of bilinear samples of one level.
class LevelSums {
public:
    HWY_INLINE LevelSums(CubeView cube, Int level) : halfs_(cube.halfs), shape_(level_shape(cube, level))
    {
        memset(sums_, 0, sizeof sums_);
    }

    // Adds the sample in direction d, of any length.
    HWY_INLINE void add(vec3 d)
    {
        find_taps(shape_, cube_from_direction(d), queue_[queued_]);
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
                total = add_weighted(total, filtered(halfs_, queue_[i], lane), 1.0f);
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

// One bilinear sample of a level, RGB over the chain's scale.
HWY_INLINE vec3 cube_bilinear(CubeView cube, vec3 d, Int level)
{
    LevelSums sums(cube, level);
    sums.add(d);
    return sums.sum();
}
