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

// How a lobe is sampled, for all its samples: view in the surface's frame; the lobe whose facets are drawn, wider than
// the surface's own; the share of them that is drawn.
struct LobeSampling {
    vec3 view;
    Real alpha;
    Real SV; // smith_ggx(NV, alpha)
    Real wide_alpha;
    vec3 stretched;
    Real reach;
    Real variance;   // of the blur at a facet of spread 1, square radians
    Real sharpening; // half of it over wide_alpha^4, times wide_alpha^2 - alpha^2
};

// The lobe of alpha as N samples see it, per_sample = 1 / N. Facets are drawn from one up to 1.25 times as wide: what
// is seen of a lamp that is brighter than white is the tail of the lobe, where else there would be too few. (At 1.42 errors
// under suns cut off at white are 5 to 8 % less, and under one that is not up to half as much again.)
// Witness: lobe_sample's.
LobeSampling lobe_sampling(vec3 view, Real alpha, Real per_sample)
{
    Real wide = alpha * (1.25 - 0.25 * alpha);
    Real a2 = alpha * alpha;
    Real w2 = wide * wide;
    Real reach = reflecting_share_ggx(view, wide);
    Real variance = variance_of_spread(reach * spread_ggx(view.z, wide)) * per_sample;
    LobeSampling s = {view,
                      alpha,
                      smith_ggx(view.z, alpha),
                      wide,
                      stretched_view(view, wide),
                      reach,
                      variance,
                      0.5 * variance * (w2 - a2) / (w2 * w2)};
    return s;
}

// One sample: the mirrored direction in the surface's frame, of length `size`; its weight in the mean, without the
// factor that all samples share; Schlick's weight; the variance of its blur in square radians.
struct LobeSample {
    vec3 direction;
    Real size;
    Real weight;
    Real grazing;
    Real variance;
};

// Blurring the samples spreads the lobe. Where the density of samples times the blur's variance s^2 is the same
// everywhere, as here, what flows out of a place is 1/2 s^2 times the gradient of their weight w: so the samples are
// moved up by 1/2 s^2 grad(log w), and the blur carries them back. That gradient is the cosine's, which lifts
// directions off the horizon, and the wider lobe's, which narrows the facets' slopes.
// [stationary flux of diffusion: Fick 1855] Witness: first moments of the blurred samples, by quadrature.
LobeSample lobe_sample(LobeSampling s, vec3 point)
{
    VisibleFacet facet = sample_visible_ggx(s.stretched, s.wide_alpha, vec3(s.reach * point.x, point.y, point.z));
    vec3 n = facet.normal;
    Real variance = s.variance * facet.spread;
    Real a2 = s.alpha * s.alpha;
    Real sine2 = n.x * n.x + n.y * n.y;
    Real cosine2 = n.z * n.z;
    Real VH = dot(s.view, n);
    // Nothing is reflected from below the horizon: this little amount keeps the mean defined where all samples are
    // such.
    Real NL = max(2.0 * VH * n.z - s.view.z, 1.0e-4);
    Real SL = smith_ggx(NL, s.alpha);
    // What is divided by: the lobe's slope, shadowing, the lift. One division does for the three.
    Real slope = max(sine2 + a2 * cosine2, 1.0e-12);
    Real both = NL * s.SV + s.view.z * SL;
    Real room = max(NL * SL * both, 3.0e-3);
    Real inverse = 1.0 / (slope * both * room);
    Real ratio = (sine2 + s.wide_alpha * s.wide_alpha * cosine2) * (both * room * inverse);
    Real weight = ratio * ratio * NL * (slope * room * inverse);
    Real lift = 0.5 * variance * s.view.z * a2 * (slope * both * inverse);
    Real z = n.z + n.z * cosine2 * s.sharpening * ratio;
    Real size = sine2 + z * z;
    Real twice = 2.0 * (VH + s.view.z * (z - n.z));
    vec3 L = twice * vec3(n.x, n.y, z) - size * s.view;
    LobeSample result = {vec3(L.x, L.y, L.z + size * lift), size, weight, schlick_weight(VH), variance};
    return result;
}

// Directions are drawn from visible normals, each moved to its own place in the pixel, and read through a blur as
// wide as the share of lobe and pixel that it stands for. The means are weighted and divided by the sum of the
// weights: a constant environment gives exactly itself for every N, and the energy is in the albedo table.
// [visible normals: Dupuy and Benyoub 2023; filtered samples: Krivanek and Colbert 2008, "Real-time shading with
// filtered importance sampling"] Witness: tests/draw, against brute force over every texel in double.
LobeLight specular_ggx(Environment environment, Mirror m)
{
    mat3 frame = carried_frame(m.normal, m.view, m.across);
    Real per_sample = 1.0 / Real(sample_count(environment));
    LobeSampling lobe = lobe_sampling(in_frame(frame, m.view), m.alpha, per_sample);
    vec3 area = cross(m.mirrored_dx, m.mirrored_dy);
    Real footprint = sqrt(dot(area, area));
    Real pixel_variance = variance_of_spread(footprint) * per_sample;
    // Where the lobe is the wider, moving samples about in the pixel only tears gaps into their spiral: they stay in
    // the middle, and the blur takes the pixel's variance, a twelfth of its area.
    Real moved = pixel_variance / max(pixel_variance + lobe.variance, 1.0e-30);
    Real shared_variance = pixel_variance + (1.0 - moved * moved) * footprint * 0.08333333333333333;
    Real per_level = 1.0 / level_one_variance(environment);
    LightSum sum = no_light(environment);
    Real plain_weight = 0.0;
    Real grazing_weight = 0.0;
    for (int i = 0; i < sample_count(environment); ++i) {
        LobeSample s = lobe_sample(lobe, cap_point(environment, i));
        // Schlick's weight is 0 head on; the mean has to stay defined there too.
        Real weight_grazing = s.weight * max(s.grazing, 1.0e-6);
        Real weight_plain = s.weight - weight_grazing;
        vec2 place = s.size * moved * pixel_point(environment, i);
        vec3 d = frame * s.direction + place.x * m.mirrored_dx + place.y * m.mirrored_dy;
        Real level = level_of_variance((s.variance + shared_variance) * per_level);
        sum = with_light(environment, sum, d, level, vec2(weight_plain, weight_grazing));
        plain_weight += weight_plain;
        grazing_weight += weight_grazing;
    }
    LobeLight light = {first_light(environment, sum) / max(plain_weight, 1.0e-20),
                       second_light(environment, sum) / max(grazing_weight, 1.0e-20)};
    return light;
}
