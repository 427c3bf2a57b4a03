// Lights without size.

// Fraction of a point light's candela that arrives as lux at distance^2: the inverse square, smoothly brought to 0 at
// its range. inverse_range in 1/m, 0 for no limit. Result in 1/m^2. [KHR_lights_punctual, "Range Property"]
// Witness: closed form at three distances.
Real distance_attenuation(Real distance2, Real inverse_range)
{
    Real x2 = distance2 * inverse_range * inverse_range;
    return clamp(1.0 - x2 * x2, 0.0, 1.0) / max(distance2, 1.0e-8);
}

// Fraction of a spot light's candela at an angle from its axis: 1 inside the inner cone, 0 outside the outer.
// [KHR_lights_punctual, "Inner and Outer Cone Angles"] Witness: both ends and the middle.
Real cone_attenuation(Real cosine, Real cos_inner, Real cos_outer)
{
    Real x = clamp((cosine - cos_outer) / max(cos_inner - cos_outer, 1.0e-3), 0.0, 1.0);
    return x * x;
}
