// Addresses of the texels that bilinear lookups in a CubeChain read, for lanes. Included by wide_cube.h: no guard.

// The members of a CubeChain that lookups read, without std:: types.
struct CubeView {
    const uint16_t* halfs;
    int log2_size;
    int levels;
};

// The texels that the lanes read of one level: offsets of the upper and the lower pair, in halfs, and the fractions by
// which the sample lies right of the left texels and below the upper ones.
struct LevelTaps {
    alignas(64) int32_t upper[max_lanes];
    alignas(64) int32_t lower[max_lanes];
    alignas(64) float right[max_lanes];
    alignas(64) float below[max_lanes];
};

// The size of a level and its start in the chain; CubeChain::texel defines the layout.
struct LevelShape {
    Real half_size;    // half of a face's side, in texels
    Int start, pitch3; // index of the first texel; halfs from row to row
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

HWY_INLINE void find_taps(LevelShape level, CubePlace p, LevelTaps& taps)
{
    // Texel centres lie half a texel inside; the border adds one texel.
    const Real middle = level.half_size + 0.5;
    const Real x = p.s * level.half_size + middle, y = p.t * level.half_size + middle;
    const Real x0 = floor(x), y0 = floor(y);
    // The index is below 2^24, up to which floats hold integers exactly.
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
    return weight_texels(mix(upper, lower, taps.below[lane]), taps.right[lane]);
}
