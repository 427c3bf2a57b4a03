// GLSL's functions over lanes, by polynomials fitted for this project (least maximum error, Lawson's method, on
// Chebyshev nodes). tests/wide measures the errors over the ranges given. Included after lanes.h: no guard, by design.

// 1 / a for a normal number whose inverse is normal: the hardware's estimate and one Newton-Raphson step; relative
// error 3e-7.
HWY_INLINE Real reciprocal(Real a)
{
    const Real r = hn::ApproximateReciprocal(a.v);
    return hn::Mul(r.v, hn::NegMulAdd(a.v, r.v, Real(2.0).v));
}

HWY_INLINE Real operator/(Real a, Real b)
{
    return a * reciprocal(b);
}

// 1 / sqrt(a) for a > 0: the hardware's estimate and one Newton-Raphson step; relative error 4e-7. The fallback's
// estimate is too coarse for that.
HWY_INLINE Real inversesqrt(Real a)
{
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128
    return hn::Div(Real(1.0).v, hn::Sqrt(a.v));
#else
    const Real r = hn::ApproximateReciprocalSqrt(a.v);
    const Real half_a_r = 0.5 * a * r;
    return hn::Mul(r.v, hn::NegMulAdd(half_a_r.v, r.v, Real(1.5).v));
#endif
}

// Horner's rule, leading coefficient first.
template <class... Rest>
HWY_INLINE Real polynomial(Real t, double first, Rest... rest)
{
    Real p = first;
    ((p = hn::MulAdd(p.v, t.v, Real(rest).v)), ...);
    return p;
}

// Exact for a normal number above 0: shifting by 24 bits instead of 23 halves the exponent.
HWY_INLINE PowersOfFour powers_of_four(Real a)
{
    const Int exponent = hn::ShiftRight<24>(hn::Sub(bits(a), integer(127 << 23)));
    return {from_bits(hn::Sub(bits(a), hn::ShiftLeft<24>(exponent))), to_real(exponent)};
}

// log2 of a normal number. The mantissa is taken in [1/sqrt 2, sqrt 2], so that the error is relative also near 1,
// where Phong exponents of 1e6 multiply it: 4e-7, next to 1 half of that.
HWY_INLINE Real log2(Real a)
{
    const Int offset = hn::Sub(bits(a), integer(0x3f3504f3));
    const Int exponent = hn::ShiftRight<23>(offset);
    const Real t = from_bits(hn::Sub(bits(a), hn::ShiftLeft<23>(exponent))) - 1.0;
    const Real p = polynomial(t, -0.145809814, 0.234041572, -0.248877123, 0.287098825, -0.360239625,
                              0.480923235, -0.721352816, 1.4426949);
    return hn::MulAdd(p.v, t.v, to_real(exponent).v);
}

// 2^a, relative error 3e-7; below -126 the result is 2^-126, above 127 it is 2^127.
HWY_INLINE Real exp2(Real a)
{
    const Real clamped = min(max(a, -126.0), 127.0);
    const Real n = hn::Round(clamped.v);
    const Real p = polynomial(clamped - n, 0.00132764666, 0.00967554096, 0.0555071346, 0.240221202,
                              0.693146944, 1.00000012);
    return from_bits(hn::Add(bits(p), hn::ShiftLeft<23>(truncated(n))));
}

// The angle of (x, y), not both below 1e-30, in [-pi, pi]; absolute error 1e-6.
HWY_INLINE Real atan(Real y, Real x)
{
    const Real ax = abs(x), ay = abs(y);
    const Real ratio = min(ax, ay) / max(max(ax, ay), 1.0e-30);
    const Real a = ratio * polynomial(ratio * ratio, 0.00800659694, -0.037442077, 0.0843530819, -0.135121241,
                                      0.198873088, -0.333270133, 0.999999404);
    const Real octant = select(ay > ax, 1.5707963267948966 - a, a);
    const Real half_plane = select(x < 0.0, 3.141592653589793 - octant, octant);
    return hn::CopySignToAbs(half_plane.v, y.v);
}

// The arc cosine of a in [-1, 1]; absolute error 1.5e-6.
HWY_INLINE Real acos(Real a)
{
    const Real b = abs(a);
    const Real p =
        polynomial(b, -0.00463306624, 0.0200193431, -0.0454821214, 0.0880399346, -0.214529768, 1.57079554);
    const Real angle = p * sqrt(max(1.0 - b, 0.0));
    return select(a < 0.0, 3.141592653589793 - angle, angle);
}

// Sine and cosine: absolute error 2e-7 for |a| up to 39000.
HWY_INLINE Real sin(Real a)
{
    return hn::Sin(FloatTag(), a.v);
}
HWY_INLINE Real cos(Real a)
{
    return hn::Cos(FloatTag(), a.v);
}
