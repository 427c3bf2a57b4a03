// Directions drawn from lobes, for rays that ask what light arrives from there. A point of the unit square is given as
// (xi2, cos 2 pi xi1, sin 2 pi xi1), as to sample_visible_ggx. Hook: has_stretch, see README.md.

// The frame in which facets with these alphas are drawn. Witness: orthonormality.
mat3 facet_frame(Metallic m, vec3 N)
{
    if (has_stretch() != 0 && any_of(is_stretched(m.alpha)))
        return frame_along(N, m.tangent);
    return orthonormal_frame(N);
}

// A direction drawn about the normal by its cosine. [Malley's method: Pharr, Jakob and Humphreys 2016, 13.6.3]
// Witness: chi-square against the cosine (tests/equations).
vec3 drawn_by_cosine(vec3 N, vec3 point)
{
    Real radius = sqrt(point.x);
    return orthonormal_frame(N) * vec3(radius * point.y, radius * point.z, sqrt(max(1.0 - point.x, 0.0)));
}

// Its density per solid angle. Witness: quadrature (tests/equations).
Real density_by_cosine(vec3 N, vec3 L) { return 0.3183098861837907 * max(dot(N, L), 0.0); }

// The view mirrored by a visible facet. It may lie below the horizon, where the surface reflects nothing.
// Witness: chi-square against density_by_facets (tests/equations).
vec3 drawn_by_facets(Metallic m, ShinyPoint s, vec3 point)
{
    mat3 frame = facet_frame(m, s.normal);
    vec3 view = in_frame(frame, s.view);
    VisibleFacet facet = sample_visible_ggx(stretched_view(view, m.alpha), m.alpha, point);
    return normalize(frame * mirrored(facet.normal, view));
}

// Its density per solid angle, D G1 / (4 NV), or 0 where the facet would look down: [Heitz 2018, JCGT 7(4), eq. 17]. Its cosine
// of the facet has the rounding error of brdf_metallic's, so that the ratio of the two is exact for the narrowest lobe.
// Witness: quadrature (tests/equations).
Real density_by_facets(Metallic m, ShinyPoint s, vec3 L)
{
    vec3 sum = L + s.view;
    Real inverse = inversesqrt(max(dot(sum, sum), 1.0e-12));
    Real NV = dot(s.normal, s.view);
    if (has_stretch() != 0 && any_of(is_stretched(m.alpha))) {
        mat3 frame = facet_frame(m, s.normal);
        vec3 H = in_frame(frame, inverse * sum);
        Real stretched = 0.5 * density_ggx(H, m.alpha) / (NV + smith_ggx(in_frame(frame, s.view), m.alpha));
        return select(H.z > 0.0, stretched, 0.0);
    }
    Real NH = clamp(dot(s.normal, sum) * inverse, 0.0, 1.0);
    return select(NH > 0.0, 0.5 * density_ggx(NH, m.alpha.x) / (NV + smith_ggx(NV, m.alpha.x)), 0.0);
}

// The view mirrored by a facet of the report's distribution. It may lie below the horizon.
// Witness: chi-square against density_by_phong (tests/equations).
vec3 drawn_by_phong(Phong p, ShinyPoint s, vec3 point)
{
    vec3 about = vec3(log2(max(point.x, 1.0e-30)), point.y, point.z);
    return normalize(mirrored(orthonormal_frame(s.normal) * sample_phong(about, p.exponent), s.view));
}

// Its density per solid angle. A facet that faces away from the view mirrors as from its back, to far below the horizon.
// Witness: quadrature (tests/equations).
Real density_by_phong(Phong p, ShinyPoint s, vec3 L)
{
    vec3 sum = L + s.view;
    Real inverse = inversesqrt(max(dot(sum, sum), 1.0e-12));
    Real NH = clamp(abs(dot(s.normal, sum)) * inverse, 1.0e-4, 1.0);
    Real VH = max(dot(s.view, sum) * inverse, 1.0e-4);
    Real log2_density = log2((p.exponent + 1.0) * 0.15915494309189535) + p.exponent * log2(NH);
    return 0.25 * exp2(max(log2_density, -120.0)) / VH;
}

// The luminance of linear light of the sRGB primaries. [ITU-R BT.709] Witness: closed form (tests/equations).
Real luminance_of(vec3 c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

// The angular variance, in square radians, of the part of the sphere that one ray of that density stands for, of `rays` in all:
// of a disc of the solid angle 1 / (rays density), about its centre and along one axis.
// Witness: the variance of a disc (tests/equations).
Real variance_of_ray(Real density, Real rays) { return 0.07957747154594767 / max(rays * density, 1.0e-6); }
