// Tone curves: from exposed linear light (Rec. 709, 0 and up) to display-linear light in [0, 1], before contrast and
// transfer. All are increasing on greys, keep greys grey, and stay in range.

// The report's curve, c / (c + 1), per channel. [Reinhard et al. 2002, eq. 3, with the luminance per channel]
// Witness: fixed points.
vec3 tone_reinhard(vec3 c) { return vec3(c.x / (c.x + 1.0), c.y / (c.y + 1.0), c.z / (c.z + 1.0)); }

// Identity, cut at 1. Witness: both sides of the cut.
vec3 tone_linear(vec3 c) { return vec3(min(c.x, 1.0), min(c.y, 1.0), min(c.z, 1.0)); }

// Khronos PBR Neutral: colours of base materials kept as they are, highlights compressed to white.
// [Khronos 2024, "PBR Neutral Specification"; F90 = 0.04, Ks = 0.8 - F90, Kd = 0.15]
// Witness: the specification's inverse undoes it; base colours come back; smooth where the pieces meet.
vec3 tone_neutral(vec3 c)
{
    Real least = min(c.x, min(c.y, c.z));
    Real offset = select(least <= 0.08, least - 6.25 * least * least, 0.04);
    vec3 low = c - vec3(offset);
    Real peak = max(low.x, max(low.y, low.z));
    Real compressed = 1.0 - 0.0576 / (max(peak, 0.76) - 0.52);
    Real whiteness = 1.0 - 1.0 / (0.15 * (peak - compressed) + 1.0);
    vec3 high = mix(low * (compressed / max(peak, 0.76)), vec3(compressed), whiteness);
    return select(peak <= 0.76, low, high);
}

// The ACES reference rendering and output transforms for sRGB as fitted by Stephen Hill (2016), exposed by 1 / 0.6 as
// in three.js and the Khronos viewer, so that middle grey stays about where it was.
// Witness: the Academy's tone scales, within the fit's error; the matrices from primaries and whites.
vec3 tone_aces(vec3 c)
{
    mat3 to_aces =
        mat3(vec3(0.59719, 0.07600, 0.02840), vec3(0.35458, 0.90834, 0.13383), vec3(0.04823, 0.01566, 0.83777));
    mat3 to_display =
        mat3(vec3(1.60475, -0.10208, -0.00327), vec3(-0.53108, 1.10813, -0.07276), vec3(-0.07367, -0.00605, 1.07602));
    vec3 v = to_aces * (min(c, vec3(1.0e6)) * (1.0 / 0.6));
    vec3 a = v * (v + vec3(0.0245786)) - vec3(0.000090537);
    vec3 b = v * (0.983729 * v + vec3(0.4329510)) + vec3(0.238081);
    return clamp(to_display * vec3(a.x / b.x, a.y / b.y, a.z / b.z), 0.0, 1.0);
}

// AgX's sigmoid on log-encoded light: through (0, 0), (0.606, 0.5) with slope 2, and (1, 1); toe power 3, shoulder
// power 3.25. The scales 59.5 and 69.9 follow from those end points. [Sobotka 2022, AgX]
// Witness: Sobotka's general form with scales worked out in double; the end points and the slope.
Real agx_sigmoid(Real x)
{
    Real d = x - 0.6060606060606061;
    Real toe = 0.5 + 2.0 * d * exp2(-0.3333333333333333 * log2(1.0 + 59.507875 * max(-d * d * d, 0.0)));
    Real shoulder = 0.5 + 2.0 * d * exp2(-0.3076923076923077 * log2(1.0 + 69.862789 * power(max(d, 0.0), 3.25)));
    return select(d < 0.0, toe, shoulder);
}

// AgX, base look: colours drawn towards grey before a log curve, so that bright saturated light turns white and keeps
// its hue. 10 stops below and 6.5 above middle grey. [Sobotka 2022, AgX, OCIO configuration: inset matrix, range]
// Witness: that definition, the outset by solving for the inset's inverse.
vec3 tone_agx(vec3 c)
{
    mat3 inset = mat3(vec3(0.842479062253094, 0.0423282422610123, 0.0423756549057051),
                      vec3(0.0784335999999992, 0.878468636469772, 0.0784336),
                      vec3(0.0792237451477643, 0.0791661274605434, 0.879142973793104));
    mat3 outset = mat3(vec3(1.19687900512017, -0.0528968517574562, -0.0529716355144438),
                       vec3(-0.0980208811401368, 1.15190312990417, -0.0980434501171241),
                       vec3(-0.0990297440797205, -0.0989611768448433, 1.15107367264116));
    vec3 v = inset * c;
    vec3 stops = vec3(log2(max(v.x, 1.0e-10)), log2(max(v.y, 1.0e-10)), log2(max(v.z, 1.0e-10)));
    vec3 x = clamp((stops + vec3(12.473931188332413)) * 0.06060606060606061, 0.0, 1.0);
    vec3 code = outset * vec3(agx_sigmoid(x.x), agx_sigmoid(x.y), agx_sigmoid(x.z));
    return power(clamp(code, 0.0, 1.0), 2.2);
}
