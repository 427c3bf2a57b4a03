// Light from the environment reflected by GGX facets, N samples. Hooks: see README.md.

// A point that mirrors, what is across for the viewer (any direction but the view, the same for a whole picture), alpha along
// the tangent and the bitangent, the tangent (not read where both are the same), and the directional albedo (energy.glsl).
struct Mirror {
    ShinyPoint at;
    vec3 across;
    vec2 alpha;
    vec3 tangent;
    vec2 albedo;
};

// The frame in which a mirror's lobe is sampled: by its tangent where it is stretched. Witness: specular_ggx's.
mat3 mirror_frame(Mirror m)
{
    if (has_stretch() != 0 && any_of(is_stretched(m.alpha)))
        return frame_along(m.at.normal, m.tangent);
    return carried_frame(m.at.normal, m.at.view, m.across);
}

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
    vec2 alpha;
    Real SV; // smith_ggx of the view
    vec2 wide_alpha;
    vec3 stretched;
    Real reach;
    Real variance;   // of the blur at a facet of spread 1, square radians
    Real sharpening; // half of it over wide_alpha^4, times wide_alpha^2 - alpha^2, both as the product of the two numbers
};

// The lobe of alpha as N samples see it, per_sample = 1 / N. Facets are drawn from one up to 1.25 times as wide: what
// is seen of a lamp that is brighter than white is the tail of the lobe, where else there would be too few. (At 1.42 errors
// under suns cut off at white are 5 to 8 % less, and under one that is not up to half as much again.)
// Witness: lobe_sample's.
LobeSampling lobe_sampling(vec3 view, vec2 alpha, Real per_sample)
{
    vec2 wide = vec2(alpha.x * (1.25 - 0.25 * alpha.x), alpha.y * (1.25 - 0.25 * alpha.y));
    Real a2 = alpha.x * alpha.y;
    Real w2 = wide.x * wide.y;
    Real reach = reflecting_share_ggx(view, wide);
    Real variance = variance_of_spread(reach * spread_ggx(view.z, smith_of(view, wide), wide)) * per_sample;
    LobeSampling s = {view,
                      alpha,
                      smith_of(view, alpha),
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

// smith_ggx of the view mirrored by a facet, whose cosine is NL. Witness: lobe_sample's.
Real smith_of_mirrored(LobeSampling s, vec3 n, Real VH, Real NL)
{
    if (has_stretch() != 0)
        return smith_ggx(vec3(2.0 * VH * n.x - s.view.x, 2.0 * VH * n.y - s.view.y, NL), s.alpha);
    return smith_ggx(NL, s.alpha.x);
}

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
    Real a2 = s.alpha.x * s.alpha.y;
    Real sine2 = n.x * n.x + n.y * n.y;
    Real cosine2 = n.z * n.z;
    Real VH = dot(s.view, n);
    // Nothing is reflected from below the horizon: this little amount keeps the mean defined where all samples are
    // such.
    Real NL = max(2.0 * VH * n.z - s.view.z, 1.0e-4);
    Real SL = smith_of_mirrored(s, n, VH, NL);
    // What is divided by: the lobe's slope, shadowing, the lift. One division does for the three.
    Real slope = max(slope_of(n, sine2, cosine2, s.alpha), 1.0e-12);
    Real both = NL * s.SV + s.view.z * SL;
    Real room = max(NL * SL * both, 3.0e-3);
    Real inverse = 1.0 / (slope * both * room);
    Real ratio = slope_of(n, sine2, cosine2, s.wide_alpha) * (both * room * inverse);
    Real weight = ratio * ratio * NL * (slope * room * inverse);
    Real lift = 0.5 * variance * s.view.z * a2 * (slope * both * inverse);
    Real z = n.z + n.z * cosine2 * s.sharpening * ratio;
    Real size = sine2 + z * z;
    Real twice = 2.0 * (VH + s.view.z * (z - n.z));
    vec3 L = twice * vec3(n.x, n.y, z) - size * s.view;
    LobeSample result = {vec3(L.x, L.y, L.z + size * lift), size, weight, schlick_weight(VH), variance};
    return result;
}

// What a lobe sends on of light from direction L, in the surface's frame, in LobeLight's two parts before they are divided
// by the albedo; and the variance of the blur that a sample there would be read through. Where the pixel sees the mirrored
// picture wider than the lobe is, the lobe is cut off at 1 / cut.
struct LampWeights {
    vec2 parts;
    Real variance;
};

// Witness: brdf_metallic.
LampWeights lamp_weights(LobeSampling s, vec3 L, Real cut)
{
    vec3 sum = L + s.view;
    Real length2 = max(dot(sum, sum), 4.0e-6);
    Real inverse = inversesqrt(length2);
    Real NL = max(L.z, 0.0);
    // Not from the cosine: its rounding is as large as the square of a narrow lobe's sine.
    Real sine2 = (sum.x * sum.x + sum.y * sum.y) * inverse * inverse;
    Real cosine2 = sum.z * sum.z * inverse * inverse;
    Real a2 = s.alpha.x * s.alpha.y;
    Real slope = sine2 + a2 * cosine2;
    if (has_stretch() != 0)
        slope = slope_ggx(inverse * sum, s.alpha);
    // density_ggx times visibility_ggx times NL, with one division.
    Real over = 0.15915494309189535 * a2 * NL;
    Real under = slope * slope * (NL * s.SV + s.view.z * smith_of(vec3(L.x, L.y, NL), s.alpha));
    Real lobe = over / max(under + cut * over, 1.0e-25);
    Real grazing = lobe * schlick_weight(min(0.5 * length2 * inverse, 1.0));
    Real spread = cosine2 + sine2 / (s.wide_alpha.x * s.wide_alpha.x);
    if (has_stretch() != 0)
        spread = slope_ggx(inverse * sum, s.wide_alpha) / (s.wide_alpha.x * s.wide_alpha.y);
    LampWeights w = {vec2(lobe - grazing, grazing), s.variance * spread * spread};
    return w;
}

// The lamps' light, to the extent that the chain is without it where a sample would read it: through the lobe, and, as far
// as the pixel is wider than that (pixel_share of 1), through the pixel. shared_variance is what all samples are blurred by.
// Witness: lamps all around are a white sky.
LobeLight lamps_ggx(Environment environment, Mirror m, LobeSampling s, Real pixel_share, Real shared_variance)
{
    mat3 frame = mirror_frame(m);
    Footprint footprint = footprint_of(m.at);
    vec2 variances = lamp_variances(environment);
    Real p2 = pixel_share * pixel_share;
    Real in_pixel = p2 * p2 * p2;
    Real cut = in_pixel * footprint.size / max(m.albedo.x + m.albedo.y, 1.0e-6);
    Real through_pixel = in_pixel * share_of_coarser(s.variance + shared_variance, variances);
    vec3 plain = vec3(0.0);
    vec3 grazing = vec3(0.0);
    vec3 mirrored_light = vec3(0.0);
    for (int i = 0; i < lamp_count(environment); ++i) {
        vec3 L = lamp_direction(environment, i);
        vec3 light = lamp_light(environment, i);
        LampWeights w = lamp_weights(s, in_frame(frame, L), cut);
        Real share = share_of_coarser(w.variance + shared_variance, variances);
        plain += (share * w.parts.x) * light;
        grazing += (share * w.parts.y) * light;
        mirrored_light += density_in_pixel(footprint, L) * light;
    }
    LobeLight sum = {plain / max(m.albedo.x, 1.0e-6) + through_pixel * mirrored_light,
                     grazing / max(m.albedo.y, 1.0e-6) + through_pixel * mirrored_light};
    return sum;
}

// The level at which a sample is read: the blur of lobe and pixel. per_level is 1 / v1. Witness: specular_ggx's.
Real matched_level_ggx(Real variance, PixelBlur pixel, Real per_level)
{
    return level_of_variance((variance + pixel.variance) * per_level);
}

// The level at which a sample in the lobe's middle is read, for looking at: there the facet faces along the normal, and its
// spread is 1. Witness: levels by the density of visible normals there (tests/draw).
Real middle_level_ggx(Environment environment, Mirror m)
{
    mat3 frame = mirror_frame(m);
    Real per_sample = 1.0 / Real(sample_count(environment));
    LobeSampling lobe = lobe_sampling(in_frame(frame, m.at.view), m.alpha, per_sample);
    return matched_level_ggx(lobe.variance, pixel_blur(m.at, lobe.variance, per_sample), 1.0 / level_one_variance(environment));
}

// Directions are drawn from visible normals, each moved to its own place in the pixel, and read through a blur as
// wide as the share of lobe and pixel that it stands for. The means are weighted and divided by the sum of the
// weights: a constant environment gives exactly itself for every N, and the energy is in the albedo table.
// [visible normals: Dupuy and Benyoub 2023; filtered samples: Krivanek and Colbert 2008, "Real-time shading with
// filtered importance sampling"] Witness: tests/draw, against brute force over every texel in double.
LobeLight specular_ggx(Environment environment, Mirror m)
{
    mat3 frame = mirror_frame(m);
    Real per_sample = 1.0 / Real(sample_count(environment));
    LobeSampling lobe = lobe_sampling(in_frame(frame, m.at.view), m.alpha, per_sample);
    PixelBlur pixel = pixel_blur(m.at, lobe.variance, per_sample);
    Real per_level = 1.0 / level_one_variance(environment);
    LightSum sum = no_light(environment);
    Real plain_weight = 0.0;
    Real grazing_weight = 0.0;
    for (int i = 0; i < sample_count(environment); ++i) {
        LobeSample s = lobe_sample(lobe, cap_point(environment, i));
        // Schlick's weight is 0 head on; the mean has to stay defined there too.
        Real weight_grazing = s.weight * max(s.grazing, 1.0e-6);
        Real weight_plain = s.weight - weight_grazing;
        vec2 place = s.size * pixel.moved * pixel_point(environment, i);
        vec3 d = frame * s.direction + place.x * m.at.mirrored_dx + place.y * m.at.mirrored_dy;
        Real level = matched_level_ggx(s.variance, pixel, per_level);
        sum = with_light(environment, sum, d, level, vec2(weight_plain, weight_grazing));
        plain_weight += weight_plain;
        grazing_weight += weight_grazing;
    }
    LobeLight lamps = lamps_ggx(environment, m, lobe, pixel.share, pixel.variance);
    LobeLight light = {lamps.plain + first_light(environment, sum) / max(plain_weight, 1.0e-20),
                       lamps.grazing + second_light(environment, sum) / max(grazing_weight, 1.0e-20)};
    return light;
}
