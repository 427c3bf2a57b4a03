// Light of the environment reflected by GGX facets, from N samples. Hooks: see README.md.

// A surface point that reflects the environment. across: the camera's right direction, or any other that is not the
// view and the same for a whole picture; alpha: along the tangent and along the bitangent; tangent: not read if both
// are equal; albedo: the directional albedo (equations/energy.glsl).
struct Mirror {
    ShinyPoint at;
    vec3 across;
    vec2 alpha;
    vec3 tangent;
    vec2 albedo;
};

// The frame in which the lobe is sampled, along its tangent if it has two different alphas.
// Witness: that of specular_ggx.
mat3 mirror_frame(Mirror m)
{
    if (has_stretch() != 0 && any_of(is_stretched(m.alpha)))
        return frame_along(m.at.normal, m.tangent);
    return carried_frame(m.at.normal, m.at.view, m.across);
}

// Radiance averaged over the lobe, weighted by Schlick's weight (grazing) and by one minus it (plain), as
// reflectance_metallic needs it.
struct LobeLight {
    vec3 plain;
    vec3 grazing;
};

// Data of a lobe that all its samples share. view: in the surface's frame; alpha: of the surface; wide_alpha: of the
// wider lobe from which facets are drawn; stretched: the view in the stretched space of wide_alpha; reach: share of
// the facets that is drawn.
struct LobeSampling {
    vec3 view;
    vec2 alpha;
    Real SV; // smith_ggx of the view
    vec2 wide_alpha;
    vec3 stretched;
    Real reach;
    Real variance;   // of the blur of a sample whose facet has spread 1, square radians
    Real sharpening; // variance / 2 (wide_alpha^2 - alpha^2) / wide_alpha^4; squares are products of the two alphas
};

// Prepares N samples of the lobe of alpha, per_sample = 1 / N. Facets are drawn from a lobe up to 1.25 times as wide:
// of a lamp brighter than white the lobe's tail is visible, where there would otherwise be too few samples. (With
// 1.42, errors under suns cut off at white are 5 to 8 % smaller, and under a sun that is not cut off up to half as
// large again.) Witness: that of lobe_sample.
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
// factor common to all samples; Schlick's weight; the variance of its blur in square radians.
struct LobeSample {
    vec3 direction;
    Real size;
    Real weight;
    Real grazing;
    Real variance;
};

// smith_ggx of the direction that facet n mirrors the view to, whose cosine is NL. Witness: that of lobe_sample.
Real smith_of_mirrored(LobeSampling s, vec3 n, Real VH, Real NL)
{
    if (has_stretch() != 0)
        return smith_ggx(vec3(2.0 * VH * n.x - s.view.x, 2.0 * VH * n.y - s.view.y, NL), s.alpha);
    return smith_ggx(NL, s.alpha.x);
}

// Blurring the samples spreads the lobe. Here the density of samples times the variance s^2 of their blur is
// constant, so that the blur moves light down the gradient of the samples' weight w by 1/2 s^2 times this gradient.
// Samples are therefore moved up by 1/2 s^2 grad(log w), and the blur moves their light back. The gradient is the sum
// of the cosine's, which lifts directions off the horizon, and the wider lobe's, which reduces the facets' slopes.
// [stationary flux of diffusion: Fick 1855]
// Witness: first moments of the blurred samples, by quadrature (tests/equations).
LobeSample lobe_sample(LobeSampling s, vec3 point)
{
    VisibleFacet facet = sample_visible_ggx(s.stretched, s.wide_alpha, vec3(s.reach * point.x, point.y, point.z));
    vec3 n = facet.normal;
    Real variance = s.variance * facet.spread;
    Real a2 = s.alpha.x * s.alpha.y;
    Real sine2 = n.x * n.x + n.y * n.y;
    Real cosine2 = n.z * n.z;
    Real VH = dot(s.view, n);
    // Samples below the horizon reflect nothing; this small cosine keeps the mean defined if all samples are below it.
    Real NL = max(2.0 * VH * n.z - s.view.z, 1.0e-4);
    Real SL = smith_of_mirrored(s, n, VH, NL);
    // The divisors of the lobe's slope, of shadowing and of the lift share one division.
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

// Reflection of light from one direction: LobeLight's two parts before division by the albedo, and the variance of
// the blur of a sample in that direction.
struct LampWeights {
    vec2 parts;
    Real variance;
};

// Reflection of light from direction L, in the surface's frame. The lobe's value is limited smoothly to 1 / cut, for
// pixels whose mirrored directions spread wider than the lobe. Witness: brdf_metallic.
LampWeights lamp_weights(LobeSampling s, vec3 L, Real cut)
{
    vec3 sum = L + s.view;
    Real length2 = max(dot(sum, sum), 4.0e-6);
    Real inverse = inversesqrt(length2);
    Real NL = max(L.z, 0.0);
    // Not 1 - cosine2, whose rounding error is as large as the squared sine of a narrow lobe.
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

// Light of the lamps, as far as the level that a sample in their direction reads does not contain them. They are seen
// through the lobe and, with weight growing with pixel_share (0 to 1: how much wider the pixel is than the lobe),
// through the pixel's footprint. shared_variance: of the blur common to all samples.
// Witness: a sky full of lamps gives the radiance of a white sky (tests/equations).
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

// The level at which a sample is read, for the blur of lobe and pixel together. per_level is 1 / v1, with v1 the
// angular variance of level 1. Witness: that of specular_ggx.
Real matched_level_ggx(Real variance, PixelBlur pixel, Real per_level)
{
    return level_of_variance((variance + pixel.variance) * per_level);
}

// The level at which a sample at the lobe's centre is read, for display as a layer: there the facet faces along the
// normal, and its spread is 1. Witness: levels by the density of visible normals there (tests/draw).
Real middle_level_ggx(Environment environment, Mirror m)
{
    mat3 frame = mirror_frame(m);
    Real per_sample = 1.0 / Real(sample_count(environment));
    LobeSampling lobe = lobe_sampling(in_frame(frame, m.at.view), m.alpha, per_sample);
    return matched_level_ggx(lobe.variance, pixel_blur(m.at, lobe.variance, per_sample),
                             1.0 / level_one_variance(environment));
}

// Directions are sampled from visible normals, each at its own position in the pixel, and read through a blur as wide
// as the share of lobe and pixel that the sample represents. Means are weighted and divided by the sum of weights: a
// constant environment gives exactly its radiance for every N, and the reflected energy is in the albedo table.
// [visible normals: Dupuy and Benyoub 2023; filtered samples: Krivanek and Colbert 2008, "Real-time shading with
// filtered importance sampling"] Witness: the sum over every texel, in double (tests/draw).
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
        // Schlick's weight is 0 at normal incidence, where the mean must stay defined.
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
