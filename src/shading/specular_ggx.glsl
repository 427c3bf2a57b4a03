// Light from the environment reflected by GGX facets, N samples. Hooks: see README.md.

// A point that mirrors: shading normal, direction to the viewer, dot(normal, view) > 0, what is across for the viewer
// (any direction but the view, the same for a whole picture), alpha, and how the mirrored direction changes from one
// pixel to the next, to the right and downwards.
struct Mirror {
    vec3 normal;
    vec3 view;
    vec3 across;
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
    mat3 frame = carried_frame(m.normal, m.view, m.across);
    vec3 view = in_frame(frame, m.view);
    Real NV = view.z;
    vec3 stretched = stretched_view(view, m.alpha);
    vec3 area = cross(m.mirrored_dx, m.mirrored_dy);
    Real per_sample = 1.0 / (Real(sample_count(environment)) * level_one_variance(environment));
    Real lobe_variance = variance_of_spread(spread_ggx(NV, m.alpha)) * per_sample;
    Real footprint = sqrt(dot(area, area));
    Real pixel_variance = variance_of_spread(footprint) * per_sample;
    // Where the lobe is the wider, moving samples about in the pixel only tears gaps into their spiral: they stay in
    // the middle, and the blur takes the pixel's variance, a twelfth of its area.
    Real moved2 = pixel_variance / max(pixel_variance + lobe_variance, 1.0e-30);
    Real moved = sqrt(moved2);
    Real shared_variance =
        pixel_variance + (1.0 - moved2) * footprint * (0.08333333333333333 / level_one_variance(environment));
    Real SV = smith_ggx(NV, m.alpha);
    LightSum sum = no_light(environment);
    Real plain_weight = 0.0;
    Real grazing_weight = 0.0;
    for (int i = 0; i < sample_count(environment); ++i) {
        VisibleFacet facet = sample_visible_ggx(stretched, m.alpha, cap_point(environment, i));
        Real VH = dot(view, facet.normal);
        vec3 L = 2.0 * VH * facet.normal - view;
        // Nothing is reflected from below the horizon, nor by Schlick's weight head on: these little amounts keep the
        // means defined where all samples are such.
        Real NL = max(L.z, 1.0e-4);
        // shadowing_ggx without the factor that all samples share
        Real weight = NL / max(NL * SV + NV * smith_ggx(NL, m.alpha), 1.0e-20);
        Real weight_grazing = weight * max(schlick_weight(VH), 1.0e-6);
        Real weight_plain = weight - weight_grazing;
        vec2 place = moved * pixel_point(environment, i);
        vec3 d = frame * L + place.x * m.mirrored_dx + place.y * m.mirrored_dy;
        Real level = level_of_variance(lobe_variance * facet.spread + shared_variance);
        sum = with_light(environment, sum, d, level, vec2(weight_plain, weight_grazing));
        plain_weight += weight_plain;
        grazing_weight += weight_grazing;
    }
    LobeLight light = {first_light(environment, sum) / max(plain_weight, 1.0e-20),
                       second_light(environment, sum) / max(grazing_weight, 1.0e-20)};
    return light;
}
