// Light from the environment reflected by GGX facets, N samples. Hooks: see README.md.

// A point that mirrors: shading normal, direction to the viewer, dot(normal, view) > 0, alpha, and how the mirrored
// direction changes from one pixel to the next, to the right and downwards.
struct Mirror {
    vec3 normal;
    vec3 view;
    Real alpha;
    vec3 mirrored_dx;
    vec3 mirrored_dy;
};

// Radiance averaged over the lobe with Schlick's weight (grazing) and with what that leaves (plain): what
// reflectance_metallic asks for.
struct LobeLight {
    vec3 plain;
    vec3 grazing;
};

// Directions are drawn from the visible normals, each moved to its own place in the pixel, and read through a blur as
// wide as the share of lobe and pixel that it stands for. The means are weighted and divided by the sum of the
// weights: a constant environment gives exactly itself for every N, and the energy is in the albedo table.
// [visible normals: Dupuy and Benyoub 2023; filtered samples: Krivanek and Colbert 2008, "Real-time shading with
// filtered importance sampling"] Witness: tests/draw, against brute force over every texel in double.
LobeLight specular_ggx(Environment environment, Mirror m)
{
    Real NV = dot(m.normal, m.view);
    Real sine = sqrt(max(1.0 - NV * NV, 0.0));
    mat3 frame = view_frame(m.normal, m.view);
    vec3 stretched = stretched_view(NV, m.alpha);
    vec3 across = cross(m.mirrored_dx, m.mirrored_dy);
    Real per_sample = 1.0 / (Real(sample_count(environment)) * level_one_variance(environment));
    Real lobe_variance = variance_of_spread(spread_ggx(NV, m.alpha)) * per_sample;
    Real pixel_variance = variance_of_spread(sqrt(dot(across, across))) * per_sample;
    Real SV = smith_ggx(NV, m.alpha);
    vec3 plain = vec3(0.0);
    vec3 grazing = vec3(0.0);
    Real plain_weight = 0.0;
    Real grazing_weight = 0.0;
    for (int i = 0; i < sample_count(environment); ++i) {
        VisibleFacet facet = sample_visible_ggx(stretched, m.alpha, cap_point(environment, i));
        Real VH = sine * facet.normal.x + NV * facet.normal.z;
        vec3 L = vec3(2.0 * VH * facet.normal.x - sine, 2.0 * VH * facet.normal.y, 2.0 * VH * facet.normal.z - NV);
        // Below the horizon nothing is reflected; that little keeps the means defined when all samples are there.
        Real NL = max(L.z, 1.0e-4);
        // shadowing_ggx without the factor that all samples share
        Real weight = NL / max(NL * SV + NV * smith_ggx(NL, m.alpha), 1.0e-20);
        Real weight_grazing = weight * schlick_weight(VH);
        Real weight_plain = weight - weight_grazing;
        vec2 place = pixel_point(environment, i);
        vec3 d = frame * L + place.x * m.mirrored_dx + place.y * m.mirrored_dy;
        Real level = level_of_variance(lobe_variance * facet.spread + pixel_variance);
        vec3 radiance = environment_radiance(environment, d, level);
        plain += weight_plain * radiance;
        grazing += weight_grazing * radiance;
        plain_weight += weight_plain;
        grazing_weight += weight_grazing;
    }
    LobeLight light = {plain / max(plain_weight, 1.0e-20), grazing / max(grazing_weight, 1.0e-20)};
    return light;
}
