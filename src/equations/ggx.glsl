// The microfacet distribution of Trowbridge and Reitz (GGX). alpha = perceptual_roughness^2, 0 < alpha <= 1: one number, with
// cosines to the normal, or two, along a tangent and along the bitangent, with directions in the frame (tangent, bitangent,
// normal). Two equal numbers are the one.

// Density of facet normals per solid angle; the integral of D NH over the hemisphere is 1. NH in [0, 1].
// [Walter et al. 2007, "Microfacet models for refraction through rough surfaces", eq. 33] Witness: quadrature.
Real density_ggx(Real NH, Real alpha)
{
    Real a2 = alpha * alpha;
    Real q = NH * NH * a2 + (1.0 - NH) * (1.0 + NH);
    return a2 / (3.141592653589793 * q * q);
}

// alpha.x alpha.y times what the density falls with the square of: with one number the q of above. Witness: density_ggx's.
Real slope_ggx(vec3 h, vec2 alpha)
{
    Real ratio = alpha.y / alpha.x;
    return h.x * h.x * ratio + h.y * h.y / ratio + alpha.x * alpha.y * h.z * h.z;
}

// The density with two numbers. [Heitz 2014, "Understanding the masking-shadowing function", eq. 85] Witness: slopes.
Real density_ggx(vec3 h, vec2 alpha)
{
    Real q = slope_ggx(h, alpha);
    return alpha.x * alpha.y / (3.141592653589793 * q * q);
}

// sqrt(1 + alpha^2 tan^2) times the cosine: Smith's masking written without a division. c in [0, 1].
// G1 = 2 c / (c + smith_ggx(c)). [Heitz 2014, "Understanding the masking-shadowing function", eq. 72]
// Witness: masking_ggx's.
Real smith_ggx(Real c, Real alpha)
{
    Real a2 = alpha * alpha;
    return sqrt(a2 + (1.0 - a2) * c * c);
}

// The same of a direction w, with two numbers: alpha is what it is along w's azimuth. [Heitz 2014, eq. 80] Witness: as before.
Real smith_ggx(vec3 w, vec2 alpha)
{
    Real x = alpha.x * w.x;
    Real y = alpha.y * w.y;
    return sqrt(x * x + y * y + w.z * w.z);
}

// Fraction of facets visible from V, G1 in [0, 1]. Witness: the visible facets' projected area equals NV.
Real masking_ggx(Real NV, Real alpha) { return 2.0 * NV / (NV + smith_ggx(NV, alpha)); }

// Height-correlated masking and shadowing over the BRDF's denominator: G2 / (4 NL NV). NL, NV in (0, 1].
// [Heitz 2014, eq. 99] Witness: G2 = 1 / (1 + lambda(V) + lambda(L)), each lambda by quadrature of D.
Real visibility_ggx(Real NL, Real NV, Real alpha)
{
    return 0.5 / max(NL * smith_ggx(NV, alpha) + NV * smith_ggx(NL, alpha), 1.0e-7);
}

// The same of two directions with two numbers. Witness: as before.
Real visibility_ggx(vec3 L, vec3 V, vec2 alpha)
{
    return 0.5 / max(L.z * smith_ggx(V, alpha) + V.z * smith_ggx(L, alpha), 1.0e-7);
}

// G2 / G1(V): what remains of a visible facet's reflection, in [0, 1]. NL and NV not both 0.
// Witness: visibility_ggx over masking_ggx.
Real shadowing_ggx(Real NL, Real NV, Real alpha)
{
    Real SV = smith_ggx(NV, alpha);
    return NL * (NV + SV) / (NL * SV + NV * smith_ggx(NL, alpha));
}

// A facet seen from V, drawn in proportion to its visible area.
struct VisibleFacet {
    vec3 normal; // in a frame whose z is the surface's normal
    Real spread; // 1 / (density per solid angle of the mirrored direction), divided by the view's spread_ggx
};

// The view, given in such a frame, in the stretched space in which GGX is a hemisphere. [Heitz 2018, JCGT 7(4), 3.2]
// Witness: that of sample_visible_ggx.
vec3 stretched_view(vec3 view, vec2 alpha) { return normalize(vec3(alpha.x * view.x, alpha.y * view.y, view.z)); }

// The factor of VisibleFacet::spread that all facets of one view share, pi alpha.x alpha.y 4 NV / G1, from smith_ggx of the view.
// Witness: the product is one over the density.
Real spread_ggx(Real NV, Real smith, vec2 alpha) { return 6.283185307179586 * alpha.x * alpha.y * (NV + smith); }

// Draws from the distribution of visible normals: a point of the spherical cap z > -stretched.z, plus the view.
// point holds (xi2, cos 2 pi xi1, sin 2 pi xi1), xi uniform in [0, 1).
// [Dupuy and Benyoub 2023, "Sampling visible GGX normals with spherical caps", listing 3; Heitz 2018]
// The density of the mirrored direction is D G1 / (4 NV); with |h|^2 the squared length before the last
// normalisation and |c|^2 that before alpha is applied, D = |h|^4 / (pi alpha.x alpha.y |c|^4), finite for every alpha.
// Witness: chi-square against that density.
VisibleFacet sample_visible_ggx(vec3 stretched, vec2 alpha, vec3 point)
{
    Real height = 1.0 + stretched.z;
    Real below = point.x * height;
    Real sine = sqrt(max(below * (2.0 - below), 0.0));
    vec3 c = vec3(sine * point.y + stretched.x, sine * point.z + stretched.y, (1.0 - point.x) * height);
    vec3 h = vec3(alpha.x * c.x, alpha.y * c.y, c.z);
    Real inverse = inversesqrt(max(dot(h, h), 1.0e-20));
    Real ratio = dot(c, c) * inverse * inverse;
    VisibleFacet facet = {inverse * h, ratio * ratio};
    return facet;
}

// The share of sample_visible_ggx's range of xi2, from 0 on, whose facets can mirror V, given in the surface's frame,
// to above the horizon; no facet beyond can. 1/2 where alpha = 1 and V is the normal, 1 where alpha = 0.
// [Eto and Tokuyoshi 2023, "Bounded VNDF sampling for Smith-GGX reflections"] Witness: facets beyond mirror below it.
Real reflecting_share_ggx(vec3 view, vec2 alpha)
{
    Real smaller = min(alpha.x, alpha.y);
    Real a2 = smaller * smaller;
    Real s = 1.0 + sqrt(max((1.0 - view.z) * (1.0 + view.z), 0.0));
    Real s2 = s * s;
    Real bound = (1.0 - a2) * s2 / (s2 + a2 * view.z * view.z);
    Real z = stretched_view(view, alpha).z;
    return (1.0 + bound * z) / (1.0 + z);
}
