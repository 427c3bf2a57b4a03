// Looking up a Panorama with lanes of directions. Included after wide/wide.h, inside the target's namespace: no guard.

// The members of a Panorama that lookups read. Texels above `limit` (before scale) are dimmed to it, keeping hue.
struct PanoramaView {
    const int32_t* texels;
    int width;
    int height;
    float limit;
};

// RGB of a texel, before the panorama's scale. [OpenGL 4.6, 8.25 "Shared Exponent Texture Color Conversion"]
HWY_INLINE vec3 unpack_texel(Int texel)
{
    const Int mask = integer(511);
    const Int exponent = hn::And(hn::ShiftRight<4>(texel), integer(0x0f800000)); // bits 27..31 to 23..27
    const Real scale = from_bits(hn::Add(exponent, integer((127 - 24) << 23)));
    return scale * vec3(to_real(hn::And(texel, mask)), to_real(hn::And(hn::ShiftRight<9>(texel), mask)),
                        to_real(hn::And(hn::ShiftRight<18>(texel), mask)));
}

HWY_INLINE vec3 dimmed(vec3 c, Real limit)
{
    const Real brightest = max(c.x, max(c.y, c.z));
    return select(brightest > limit, (limit / max(brightest, 1.0e-30)) * c, c);
}

HWY_INLINE vec3 panorama_texel(PanoramaView p, Int x, Int y)
{
    const Int index = hn::Add(hn::Mul(y, integer(p.width)), x);
    return dimmed(unpack_texel(hn::GatherIndex(IntTag(), p.texels, index)), p.limit);
}

// The column half a turn away, for rows beyond a pole.
HWY_INLINE Int opposite(PanoramaView p, Int x)
{
    const Int moved = hn::Add(x, integer(p.width / 2));
    return hn::IfThenElse(hn::Lt(moved, integer(p.width)), moved, hn::Sub(moved, integer(p.width)));
}

// Interpolates two texels of row y, which may be one beyond either pole: there the panorama continues across the pole.
HWY_INLINE vec3 panorama_row(PanoramaView p, Int left, Int right, Int y, Real fraction)
{
    const auto beyond = hn::Or(hn::Lt(y, integer(0)), hn::Gt(y, integer(p.height - 1)));
    const Int row = hn::Max(hn::Min(y, integer(p.height - 1)), integer(0));
    const vec3 a = panorama_texel(p, hn::IfThenElse(beyond, opposite(p, left), left), row);
    const vec3 b = panorama_texel(p, hn::IfThenElse(beyond, opposite(p, right), right), row);
    return mix(a, b, fraction);
}

// The texel at panorama coordinates in [0, 1], as radiance over the panorama's scale.
HWY_INLINE vec3 panorama_nearest(PanoramaView p, vec2 uv)
{
    const Int last_x = integer(p.width - 1), last_y = integer(p.height - 1), zero = hn::Zero(IntTag());
    const Int x = hn::Max(hn::Min(truncated(uv.x * Real(p.width)), last_x), zero);
    const Int y = hn::Max(hn::Min(truncated(uv.y * Real(p.height)), last_y), zero);
    return panorama_texel(p, x, y);
}

// A bilinear lookup at panorama coordinates in [0, 1], as radiance over the panorama's scale.
HWY_INLINE vec3 panorama_bilinear(PanoramaView p, vec2 uv)
{
    const Real x = uv.x * Real(p.width) - 0.5, y = uv.y * Real(p.height) - 0.5;
    const Real x0 = floor(x), y0 = floor(y);
    const Int width = integer(p.width), zero = hn::Zero(IntTag());
    const Int first = hn::Min(truncated(x0), hn::Sub(width, integer(1)));
    const Int next = hn::Add(first, integer(1));
    const Int left = hn::IfThenElse(hn::Lt(first, zero), hn::Add(first, width), first);
    const Int right = hn::IfThenElse(hn::Lt(next, width), next, zero);
    const Int row = truncated(y0);
    const vec3 above = panorama_row(p, left, right, row, x - x0);
    const vec3 below = panorama_row(p, left, right, hn::Add(row, integer(1)), x - x0);
    return mix(above, below, y - y0);
}
