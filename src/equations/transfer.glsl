// Conversions between light and code values, both in [0, 1].

// a^b for b > 0; 0 for a of 0 or below. Witness: std::pow.
Real power(Real a, Real b) { return select(a > 0.0, exp2(b * log2(max(a, 1.0e-30))), 0.0); }

// The exact sRGB curve. [IEC 61966-2-1] Witness: published codes; continuity at the joint; round trip.
Real srgb_encode(Real light)
{
    return select(light <= 0.0031308, 12.92 * light, 1.055 * power(light, 1.0 / 2.4) - 0.055);
}

// The inverse of srgb_encode. Witness: published codes; round trip.
Real srgb_decode(Real code)
{
    return select(code <= 0.04045, code * (1.0 / 12.92), power((code + 0.055) * (1.0 / 1.055), 2.4));
}

// Each channel of a colour. Witness: the channels one by one.
vec3 power(vec3 a, Real b) { return vec3(power(a.x, b), power(a.y, b), power(a.z, b)); }

// Each channel of a colour. Witness: the channels one by one.
vec3 srgb_encode(vec3 light) { return vec3(srgb_encode(light.x), srgb_encode(light.y), srgb_encode(light.z)); }
