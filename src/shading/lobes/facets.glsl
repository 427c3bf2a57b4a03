// GGX facets with two alphas, along the tangent and along the bitangent; directions are in the frame (tangent,
// bitangent, normal). In scenes where the two are always equal, simpler code for one alpha is used.
// Hook: has_stretch, see README.md.

// Whether the two alphas differ. Witness: both cases.
Mask is_stretched(vec2 alpha) { return abs(alpha.x - alpha.y) > 0.0; }

// smith_ggx with two alphas, or with one where that suffices. Witness: both forms of smith_ggx.
Real smith_of(vec3 w, vec2 alpha)
{
    if (has_stretch() != 0)
        return smith_ggx(w, alpha);
    return smith_ggx(w.z, alpha.x);
}

// slope_ggx of a unit vector. Callers pass sine2, because they may know it with less rounding error than 1 - h.z^2.
// Witness: both forms of slope_ggx.
Real slope_of(vec3 h, Real sine2, Real cosine2, vec2 alpha)
{
    if (has_stretch() != 0)
        return slope_ggx(h, alpha);
    return sine2 + alpha.x * alpha.x * cosine2;
}
