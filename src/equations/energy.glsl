// Compensation of the energy that single scattering loses on rough surfaces, and the energy left for the layer below.
// `albedo` holds the two parts of the directional albedo of GGX at one NV and alpha: for reflectance F0 it is
// F0 * albedo.x + albedo.y (the split-sum table). [Karis 2013, "Real shading in Unreal Engine 4"]

// Factor that restores the light scattered more than once: 1 + F0 (1 - E) / E, with E the albedo of a white metal;
// `compensation`, 0 to 1, is the share restored. [Turquin 2019, "Practical multiple scattering compensation for
// microfacet models"]
// Witness: the white furnace is 1 at every roughness.
vec3 energy_compensation(vec3 F0, vec2 albedo, Real compensation)
{
    Real E = albedo.x + albedo.y;
    return 1.0 + (compensation * (1.0 - E) / max(E, 1.0e-4)) * F0;
}

// A metallic-roughness material at one point. base is linear RGB; metalness and alpha in [0, 1], alpha along the tangent and
// along the bitangent. tangent: a unit vector in the surface, not read where both are the same. compensation is 1, or 0 to leave
// out light scattered more than once.
struct Metallic {
    vec3 base;
    Real metalness;
    vec2 alpha;
    vec3 tangent;
    Real compensation;
};

// Factors of the reflected light: plain * (radiance averaged over the lobe with weight 1 - (1 - VH)^5) + grazing * (the
// same with weight (1 - VH)^5) + diffuse * irradiance / pi.
struct Reflectance {
    vec3 plain;
    vec3 grazing;
    vec3 diffuse;
};

// The material as a mixture: dielectric over a diffuse base, and metal of F0 = base, each with its own
// compensation, mixed by metalness. Both are white in the white furnace when base is. [glTF 2.0, appendix B;
// diffuse under the dielectric by albedo scaling: OpenPBR 1.0, "Albedo-scaling"] Witness: the white furnace.
Reflectance reflectance_metallic(Metallic m, vec2 albedo)
{
    Real F0 = dielectric_reflectance();
    vec3 dielectric_gain = (1.0 - m.metalness) * energy_compensation(vec3(F0), albedo, m.compensation);
    vec3 metal_gain = m.metalness * energy_compensation(m.base, albedo, m.compensation);
    vec3 plain = albedo.x * (F0 * dielectric_gain + m.base * metal_gain);
    vec3 grazing = albedo.y * (dielectric_gain + metal_gain);
    vec3 under = (1.0 - m.metalness) - (F0 * albedo.x + albedo.y) * dielectric_gain;
    Reflectance r = {plain, grazing, m.base * under};
    return r;
}

// The BRDF of the same mixture, per steradian, where the facets' lobe, density_ggx times visibility_ggx, is known.
// Witness: brdf_metallic's.
vec3 brdf_of_lobe(Metallic m, vec2 albedo, Real lobe, Real VH)
{
    Reflectance r = reflectance_metallic(m, albedo);
    vec3 metal = m.metalness * (energy_compensation(m.base, albedo, m.compensation) * fresnel_schlick(m.base, VH));
    vec3 F0 = vec3(dielectric_reflectance());
    vec3 dielectric = (1.0 - m.metalness) * (energy_compensation(F0, albedo, m.compensation) * fresnel_schlick(F0, VH));
    return lobe * (metal + dielectric) + 0.3183098861837907 * r.diffuse;
}

// The same at one pair of directions, NL and NV > 0, for two equal alphas.
// Witnesses: quadrature gives reflectance_metallic's albedo; the white furnace.
vec3 brdf_metallic(Metallic m, vec2 albedo, vec3 N, vec3 V, vec3 L)
{
    vec3 sum = L + V;
    Real inverse = inversesqrt(max(dot(sum, sum), 1.0e-12));
    Real NL = dot(N, L);
    Real NV = dot(N, V);
    Real NH = clamp(dot(N, sum) * inverse, 0.0, 1.0);
    Real VH = clamp(dot(V, sum) * inverse, 0.0, 1.0);
    Real alpha = m.alpha.x;
    return brdf_of_lobe(m, albedo, density_ggx(NH, alpha) * visibility_ggx(NL, NV, alpha), VH);
}

// The same for any two alphas: the columns of `frame` are tangent, bitangent and normal. Witness: reciprocity, and slopes.
vec3 brdf_metallic(Metallic m, vec2 albedo, mat3 frame, vec3 V, vec3 L)
{
    vec3 sum = L + V;
    vec3 H = inversesqrt(max(dot(sum, sum), 1.0e-12)) * sum;
    Real lobe = density_ggx(in_frame(frame, H), m.alpha) * visibility_ggx(in_frame(frame, L), in_frame(frame, V), m.alpha);
    return brdf_of_lobe(m, albedo, lobe, clamp(dot(V, H), 0.0, 1.0));
}
