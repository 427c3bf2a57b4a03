// GGX facets that may be stretched: alpha along the tangent and along the bitangent, directions in the frame (tangent, bitangent,
// normal). Where nothing in the scene is stretched the two are one number, and cosines do. Hook: has_stretch, see README.md.

// Whether the two differ. Witness: both cases.
Mask is_stretched(vec2 alpha) { return abs(alpha.x - alpha.y) > 0.0; }

// smith_ggx. Witness: both forms of it.
Real smith_of(vec3 w, vec2 alpha)
{
    if (has_stretch() != 0)
        return smith_ggx(w, alpha);
    return smith_ggx(w.z, alpha.x);
}

// slope_ggx of a unit vector, whose sine is given as it may be known to more digits than 1 - h.z^2. Witness: both forms.
Real slope_of(vec3 h, Real sine2, Real cosine2, vec2 alpha)
{
    if (has_stretch() != 0)
        return slope_ggx(h, alpha);
    return sine2 + alpha.x * alpha.x * cosine2;
}
