// Weight of the grazing part of Schlick's reflectance, (1 - VH)^5 for VH in [0, 1].
// [Schlick 1994, "An inexpensive BRDF model for physically-based rendering", eq. 15]
// Witness: the exact Fresnel equations of a dielectric, within 0.045 for indices from 1.5 to 2.
Real schlick_weight(Real VH)
{
    Real m = 1.0 - VH;
    Real m2 = m * m;
    return m2 * m2 * m;
}

// Reflectance of a facet: F0 at normal incidence, 1 at grazing. F0 in [0, 1], per colour channel.
// Witness: that of schlick_weight.
vec3 fresnel_schlick(vec3 F0, Real VH) { return F0 + schlick_weight(VH) * (1.0 - F0); }

// Reflectance of a dielectric at normal incidence: an index of refraction of 1.5. [glTF 2.0, B.2]
// Witness: Fresnel's equations there.
Real dielectric_reflectance() { return 0.04; }

// The reflectance of a metallic-roughness material at normal incidence: a dielectric's, or for a metal its colour.
// [glTF 2.0, B.3.5] Witness: both ends.
vec3 base_reflectance(vec3 base, Real metalness) { return mix(vec3(dielectric_reflectance()), base, metalness); }
