// The report's model. alpha is the Phong exponent here, 0 < alpha <= 1e6; it is not a roughness.

// Density of facet normals, D(H) = (alpha + 2) / (2 pi) NH^alpha, as log2: alpha reaches 1e6, where D itself is
// 0 or large. NH in (0, 1]. Per solid angle; the integral of D NH over the hemisphere is 1.
// [Walter et al. 2007, "Microfacet models for refraction through rough surfaces", eq. 30] Witness: quadrature.
Real log2_density_phong(Real NH, Real alpha) { return log2((alpha + 2.0) * 0.15915494309189535) + alpha * log2(NH); }

// The report's masking over 4: 1 / (4 (L.H)^2), given VH = LH. [Kelemen and Szirmay-Kalos 2001, eq. 7]
// Witness: brdf_phong's closed form.
Real masking_phong(Real VH) { return 0.25 / max(VH * VH, 1.0e-6); }

// The report's material at one point. diffuse is Kd, specular Ks, both linear RGB in [0, 1].
struct Phong {
    vec3 diffuse;
    vec3 specular;
    Real exponent;
};

// f = Kd / pi + D(H) F(L, H) / (4 (L.H)^2), per steradian. Witnesses: reciprocity, closed form at L = V = N.
vec3 brdf_phong(Phong p, vec3 N, vec3 V, vec3 L)
{
    vec3 sum = L + V;
    Real inverse = inversesqrt(max(dot(sum, sum), 1.0e-12));
    Real NH = clamp(dot(N, sum) * inverse, 1.0e-4, 1.0);
    Real VH = min(dot(V, sum) * inverse, 1.0);
    Real D = exp2(max(log2_density_phong(NH, p.exponent), -120.0));
    return 0.3183098861837907 * p.diffuse + (D * masking_phong(VH)) * fresnel_schlick(p.specular, VH);
}

// Direction about +z with density (alpha + 1) / (2 pi) cos^alpha per solid angle, from a point that holds
// (log2 xi2, cos 2 pi xi1, sin 2 pi xi1), xi uniform in (0, 1): cos theta = xi2^(1 / (alpha + 1)).
// [Colbert and Krivanek 2007, GPU Gems 3 ch. 20, eq. 7-8] Witness: chi-square against the density.
vec3 sample_phong(vec3 point, Real alpha)
{
    Real cosine = exp2(point.x / (alpha + 1.0));
    // 1 - cos^2 loses its digits where the lobe is narrow: there a series in -ln cos^2.
    Real e = point.x * (-1.3862943611198906 / (alpha + 1.0));
    Real series = e * (1.0 - e * (0.5 - e * (0.16666666666666666 - e * 0.041666666666666664)));
    Real sine2 = select(e < 0.01, series, 1.0 - cosine * cosine);
    Real sine = sqrt(max(sine2, 0.0));
    return vec3(sine * point.y, sine * point.z, cosine);
}

// log2 of the density of sample_phong, where the cosine is xi2^(1 / (alpha + 1)), from log2 xi2.
// Witness: quadrature over the hemisphere gives 1.
Real log2_lobe_density_phong(Real log2_xi2, Real alpha)
{
    return log2((alpha + 1.0) * 0.15915494309189535) + alpha / (alpha + 1.0) * log2_xi2;
}

// The exponent whose density of normals has the same peak as GGX of roughness alpha, 1 / (pi alpha^2): 2 / alpha^2 - 2,
// kept in the model's range. alpha = perceptual_roughness^2. [Walter et al. 2007, 5.2; Karis 2013]
// Witness: both densities at NH = 1.
Real phong_exponent(Real alpha) { return clamp(2.0 / max(alpha * alpha, 1.0e-7) - 2.0, 0.01, 1.0e6); }

// The inverse of phong_exponent within that range: the roughness alpha with an equally high peak. Witness: round trip.
Real phong_alpha(Real exponent) { return sqrt(2.0 / (exponent + 2.0)); }
